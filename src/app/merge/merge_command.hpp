// `penumbra merge`: the parts that `render --shard` wrote, in any order, become the picture that a single render would
// have written, to the byte.
#pragma once

#include <string>
#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra {

struct MergeOptions {
  std::vector<std::string> parts;
  std::vector<std::string> outputs;
  bool quiet = false;
};

// The subcommand `merge`; its options fill `options`, which has to outlive it.
Subcommand merge_subcommand(MergeOptions& options);

// Returns the exit code: 0, 65 where parts are missing, damaged, there twice or of other pictures, 66 where there is no
// such file, 73, 74. Nothing is written unless it is 0, 73 or 74.
int merge_command(const MergeOptions& options);

}  // namespace penumbra
