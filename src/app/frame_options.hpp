// The options of animations: which frames are rendered, and what becomes of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "picture/frame_of_range.hpp"

namespace CLI {
class App;
}

namespace penumbra {

inline constexpr int last_possible_frame = 999999;

// Frames first, first + step, ... of an animation that runs from `first` to `last`.
struct FrameRange {
  int first = 0, last = 0, step = 1;
};

struct FrameOptions {
  std::optional<FrameRange> range;  // none: the scene is a still picture
  std::optional<int> only;          // of the range, this frame alone
  std::string video;                // all frames as a video go to this file; empty: none
  double frames_per_second = 24;
};

// Adds the options to a command; parsing throws CLI::ParseError for what is no good by itself.
void add_frame_options(CLI::App& command, FrameOptions& options);

// Throws CLI::ParseError for options that do not go together.
void check_frame_options(const FrameOptions& options);

// The frames to render; without a range one that is none.
std::vector<std::optional<FrameOfRange>> frames_to_render(const FrameOptions& options);

// OUT.0007.ext for OUT.ext: as many digits as the last frame of the animation has, and four at least.
std::filesystem::path with_frame_number(const std::filesystem::path& file, const FrameOfRange& frame);

}  // namespace penumbra
