// What `penumbra render` can be told on its command line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/sitting_options.hpp"
#include "rendering/plan.hpp"
#include "sampling/pattern.hpp"
#include "tracing/lens_model.hpp"

namespace CLI {
class App;
}

namespace penumbra {

struct Kernel;

enum class ProgressStyle { automatic, bar, plain, json, none };

// Options left out are empty: the scene's own word counts then.
struct RenderOptions {
  std::string scene;
  std::vector<std::string> outputs;
  std::optional<int> rays, max_depth;
  std::optional<int> reflection_rays, transmission_rays, shadow_rays;
  std::optional<std::uint32_t> seed;
  std::optional<double> time;
  std::optional<double> noise;  // adaptive: the standard error of a pixel; `rays` is then the most a pixel gets
  std::optional<Pattern> sampler;
  std::optional<std::pair<int, int>> size;
  std::optional<Crop> crop;
  int threads = 0;                 // 0: as many as there are
  const Kernel* kernel = nullptr;  // null: the widest that can run here
  int bits = 8;
  LensModel lens_model = LensModel::thin;
  bool no_shadows = false, transparent_shadows = false, regular_lights = false;
  bool course = false, lenient = false, quiet = false;
  Layers layers;
  ProgressStyle progress = ProgressStyle::automatic;
  std::string stats;
  SittingOptions sitting;
};

// Adds the subcommand `render` to `app`; parsing fills `options` and throws CLI::ParseError for what is no good.
CLI::App* add_render(CLI::App& app, RenderOptions& options);

}  // namespace penumbra
