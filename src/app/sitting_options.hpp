// The options of renders that take longer than one sitting or more than one machine.
#pragma once

#include <optional>
#include <string>

#include "rendering/shard.hpp"

namespace CLI {
class App;
}

namespace penumbra {

inline constexpr double longest_duration = 1e8;  // seconds

struct SittingOptions {
  std::string checkpoint;            // the file; empty: none
  double every = 30;                 // seconds
  bool resume = false;               // go on from the checkpoint, if there is one
  std::optional<double> time_limit;  // seconds
  std::optional<Shard> shard;
  std::string scene_hash;  // what the scene's files must have, in hexadecimal digits; empty: anything
  bool animation = false;  // finished frames remain, so it can be gone on with them without a checkpoint

  // Whether there is anything to do when the render is interrupted.
  bool has_end_in_mind() const { return !checkpoint.empty() || time_limit.has_value() || animation; }
};

// Adds the options to a command; parsing throws CLI::ParseError for what is no good.
void add_sitting_options(CLI::App& command, SittingOptions& options);

}  // namespace penumbra
