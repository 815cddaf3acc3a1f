#include "app/merge_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "app/part_file.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"
#include "picture/develop.hpp"

namespace penumbra {
namespace {

void complain(const std::string& sentence) { fmt::print(stderr, "penumbra: {}\n", sentence); }

// Files and their bytes, which parts point into.
struct Parts {
  std::vector<std::vector<std::byte>> bytes;
  std::vector<Part> parts;
  int exit_code = 0;  // of the worst file
};

Parts read_parts(const std::vector<std::string>& names) {
  Parts result;
  for (const std::string& name : names) {
    try {
      result.bytes.push_back(read_file(name));
      result.parts.emplace_back(part_in_file(result.bytes.back(), name), name);
    } catch (const FileError& error) {
      complain(error.what());
      result.exit_code = result.exit_code == EX_DATAERR ? EX_DATAERR : error.exit_code;
    }
  }
  return result;
}

int merge_parts(const MergeOptions& options) {
  const Parts parts = read_parts(options.parts);
  int exit_code = parts.exit_code;
  if (!parts.parts.empty()) {
    for (const std::string& sentence : complaints_about(parts.parts)) {
      complain(sentence);
      exit_code = exit_code == 0 ? EX_DATAERR : exit_code;
    }
  }
  if (exit_code != 0) return exit_code;

  const PartHeader& header = parts.parts.front().header();
  Development development;
  try {
    development = development_from(header.development);
  } catch (const ArchiveError& error) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is a damaged part: {}", options.parts.front(), error.what()));
  }
  const ImageFile image = develop(merge(parts.parts), development);
  for (const std::string& output : options.outputs) {
    write_image(output, image, {development.bits, development.rounding});
    if (!options.quiet) {
      fmt::print(stderr, "{}: {}x{} pixels, of {} parts\n", output, header.crop.width(), header.crop.height(),
                 options.parts.size());
    }
  }
  return 0;
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
