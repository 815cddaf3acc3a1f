// The command-line options of `penumbra render`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/options/command_line.hpp"
#include "app/options/machine_options.hpp"
#include "app/options/session_options.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

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
  std::string video;                        // the file for a video of all frames; empty: none
  std::optional<double> frames_per_second;  // of the video; none: 24
  std::string stats;                        // a JSON file; empty: none
  ProgressStyle progress = ProgressStyle::automatic;
  bool quiet = false;
};

// The subcommand `render`; its options write to `options`, which must outlive it.
Subcommand render_subcommand(RenderOptions& options);

}  // namespace penumbra
