// Options for renders that take more than one session or more than one machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/command_line.hpp"
#include "rendering/shard.hpp"

namespace penumbra {

inline constexpr double seconds_between_checkpoints = 30;  // where no option says another
inline constexpr double longest_duration = 1e8;            // seconds

struct RenderSessionOptions {
  std::string checkpoint;            // the file; empty: none
  std::optional<double> every;       // seconds between two checkpoints; none: 30
  bool keep_checkpoint = false;      // when all is done
  bool resume = false;               // from the checkpoint, if there is one
  std::optional<double> time_limit;  // seconds
  std::optional<Shard> shard;
  std::string scene_hash;  // required of the scene's files, in hexadecimal digits; empty: any
  bool animation = false;  // finished frames are kept, so it can be resumed without a checkpoint

  // Whether an interrupted render has something to save, to write or to resume.
  bool can_be_interrupted() const { return !checkpoint.empty() || time_limit.has_value() || animation; }
};

std::vector<CommandOption> session_options(RenderSessionOptions& options);

}  // namespace penumbra
