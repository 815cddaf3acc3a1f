// `penumbra merge`: turns the parts that `render --shard` wrote, in any order, into the picture that a single render
// would have written, byte for byte.
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

// The subcommand `merge`; its options write to `options`, which must outlive it. Exit codes: 0, 64 if an output is a
// part or another output, 65 if parts are missing, damaged, duplicated or from different pictures, 66 if a file does
// not exist, 73, 74. Nothing is written unless it is 0, 73 or 74.
Subcommand merge_subcommand(MergeOptions& options);

}  // namespace penumbra
