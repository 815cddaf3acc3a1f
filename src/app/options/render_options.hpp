// The command-line options of `penumbra render`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/options/command_line.hpp"
#include "app/options/shared_options.hpp"
#include "picture/picture_options.hpp"
#include "rendering/plan.hpp"

namespace penumbra {

// Options for renders that take more than one session or more than one machine.
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

enum class ProgressStyle { automatic, bar, plain, json, none };

// One sample of one pixel.
struct DebugPixel {
  int x = 0, y = 0, sample = 0;
};

struct RenderOptions : PictureOptions {
  std::string scene;
  std::vector<std::string> outputs;
  std::optional<DebugPixel> debug_pixel;  // print its rays instead of rendering
  MachineOptions machine;
  RenderSessionOptions session;
  std::string video;                          // the file for a video of all frames; empty: none
  std::optional<double> frames_per_second;    // of the video; none: 24
  std::string stats;                          // a JSON file; empty: none
  std::optional<std::uint64_t> memory_limit;  // bytes; none: what is available
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
};

// The subcommand `render`; its options write to `options`, which must outlive it.
Subcommand render_subcommand(RenderOptions& options);

}  // namespace penumbra
