#include "app/merge/merge_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdlib>

#include "app/files/path_table.hpp"
#include "app/merge/part_file.hpp"
#include "app/render/outputs.hpp"
#include "base/say.hpp"
#include "image/image_file.hpp"

namespace penumbra {
namespace {

// The outputs, with the number of the frame where they have a place for it.
std::vector<std::string> outputs_of(const MergeOptions& options, const Part& part) {
  std::vector<std::string> outputs = options.outputs;
  const std::string frame = value_of("frame", part.header().key);
  if (frame == not_given) return outputs;
  for (std::string& output : outputs) {
    output = with_frame_in_pattern(output, std::atoi(frame.c_str())).value_or(output).string();
  }
  return outputs;
}

// Throws FileError 64 if an output is a part or another output.
void require_own_files(const std::vector<std::string>& parts, const std::vector<std::string>& outputs) {
  PathTable table;
  for (const std::string& part : parts) table.reads(part, "a part");
  for (const std::string& output : outputs) table.writes(output, "-o");
}

// Returns the exit code: 0, or 65 or 66 if a part is missing, damaged, duplicated or of another picture. Nothing is
// written unless it is 0. Throws FileError.
int merge_parts(const MergeOptions& options) {
  const PartFiles files = read_parts(options.parts);
  std::vector<std::string> outputs;
  if (!files.parts.empty()) {
    outputs = outputs_of(options, files.parts.front());
    require_own_files(options.parts, outputs);
  }
  int exit_code = 0;
  for (const PartFiles::Failure& failure : files.failures) {
    complain(failure.error.what());
    exit_code = exit_code == EX_DATAERR ? EX_DATAERR : failure.error.exit_code;
  }
  if (!files.parts.empty()) {
    for (const std::string& sentence : problems_of(files.parts)) {
      complain(sentence);
      exit_code = exit_code == 0 ? EX_DATAERR : exit_code;
    }
  }
  if (exit_code == 0) write_merged(files.parts, outputs, options.quiet);
  return exit_code;
}

}  // namespace

Subcommand merge_subcommand(MergeOptions& options) {
  Subcommand merge{"merge", "Merge the parts that `render --shard` wrote", {}, {}, {}, {}, {}, {}};
  merge.options = {{"PART", "FILE", "The parts of one picture, in any order", into(options.parts), Times::many, true},
                   {"-o,--output", "FILE",
                    "A file for the picture, .png or .exr, or - for a PNG on standard output; may be repeated",
                    into_outputs(options.outputs), Times::repeated, true},
                   {"--quiet", "", "Print nothing but errors [off]", into(options.quiet)}};
  merge.check = [&options] {
    for (const std::string& output : options.outputs) {
      if (format_of(output) == ImageFormat::none) {
        return fmt::format("-o: `{}` ends neither in .png nor in .exr", output);
      }
    }
    return std::string();
  };
  merge.run = [&options] { return merge_parts(options); };
  return merge;
}

}  // namespace penumbra
