#include "app/merge_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/part_files.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"

namespace penumbra {
namespace {

void complain(const std::string& sentence) { fmt::print(stderr, "penumbra: {}\n", sentence); }

int merge_parts(const MergeOptions& options) {
  const PartFiles files = read_parts(options.parts);
  int exit_code = 0;
  for (const PartFiles::Failure& failure : files.failures) {
    complain(failure.error.what());
    exit_code = exit_code == EX_DATAERR ? EX_DATAERR : failure.error.exit_code;
  }
  if (!files.parts.empty()) {
    for (const std::string& sentence : complaints_about(files.parts)) {
      complain(sentence);
      exit_code = exit_code == 0 ? EX_DATAERR : exit_code;
    }
  }
  if (exit_code == 0) write_merged(files.parts, options.outputs, options.quiet);
  return exit_code;
}

}  // namespace

CLI::App* add_merge(CLI::App& app, MergeOptions& options) {
  CLI::App* merge = app.add_subcommand("merge", "Put the parts together that `render --shard` wrote");
  merge->add_option("PART", options.parts, "The parts of one picture, in any order")->required();
  merge->add_option("-o,--output", options.outputs, "A file for the picture, .png or .exr; may be repeated")
      ->required()
      ->allow_extra_args(false)
      ->type_name("FILE");
  merge->add_flag("--quiet", options.quiet, "Print nothing but errors [off]");
  merge->final_callback([&options] {
    for (const std::string& output : options.outputs) {
      if (format_of(output) == ImageFormat::none) {
        throw CLI::ValidationError("-o", fmt::format("`{}` ends neither in .png nor in .exr", output));
      }
    }
  });
  return merge;
}

int merge_command(const MergeOptions& options) {
  try {
    return merge_parts(options);
  } catch (const FileError& error) {
    complain(error.what());
    return error.exit_code;
  }
}

}  // namespace penumbra
