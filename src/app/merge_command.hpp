// `penumbra merge`: the parts that `render --shard` wrote, in any order, become the picture that a single render would
// have written, to the byte.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace penumbra {

struct MergeOptions {
  std::vector<std::string> parts;
  std::vector<std::string> outputs;
  bool quiet = false;
};

// Adds the subcommand `merge` to `app`.
CLI::App* add_merge(CLI::App& app, MergeOptions& options);

// Returns the exit code: 0, 65 where parts are missing, damaged, there twice or of other pictures, 66 where there is no
// such file, 73, 74. Nothing is written unless it is 0, 73 or 74.
int merge_command(const MergeOptions& options);

}  // namespace penumbra
