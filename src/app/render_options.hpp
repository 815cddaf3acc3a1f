// What `penumbra render` can be told on its command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frame_options.hpp"
#include "app/sitting_options.hpp"
#include "picture/picture_options.hpp"
#include "rendering/plan.hpp"

namespace CLI {
class App;
}

namespace penumbra {

struct Kernel;

enum class ProgressStyle { automatic, bar, plain, json, none };

// One sample of one pixel.
struct DebugPixel {
  int x = 0, y = 0, sample = 0;
};

struct RenderOptions : PictureOptions {
  std::string scene;
  std::vector<std::string> outputs;
  std::optional<DebugPixel> debug_pixel;  // tell its rays instead of rendering
  int threads = 0;                        // 0: as many as there are
  const Kernel* kernel = nullptr;         // null: the widest that can run here
  int bits = 8;
  bool quiet = false;
  Layers layers;
  ProgressStyle progress = ProgressStyle::automatic;
  std::string stats;
  SittingOptions sitting;
  FrameOptions frames;
};

// Adds the subcommand `render` to `app`; parsing fills `options` and throws CLI::ParseError for what is no good.
CLI::App* add_render(CLI::App& app, RenderOptions& options);

}  // namespace penumbra
