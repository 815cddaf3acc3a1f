// Checkpoints from arbitrary bytes: refused, or resumed to the end. The first byte chooses the kind of render.
#include <cstdint>
#include <memory>
#include <string_view>

#include "base/atomic_file.hpp"
#include "invariants.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/checkpoint.hpp"
#include "rendering/uniform_render.hpp"

namespace {

using namespace penumbra;

constexpr std::uint32_t rays = 64;

std::unique_ptr<ResumableRender> render_for(std::uint8_t kind, const Frame& frame, const Kernel& kernel) {
  Plan plan;
  plan.crop = (kind & 1) != 0 ? PixelRect{5, 3, 12, 9} : PixelRect{0, 0, 18, 10};
  if ((kind & 2) != 0) {
    for (const LayerRow& row : layer_table) plan.layers.add(row.layer);
  }
  if ((kind & 4) != 0) plan.shard = {1, 2};
  if ((kind & 8) != 0) return std::make_unique<AdaptiveRender>(frame, kernel, plan, NoiseGoal{0.05f, rays});
  return std::make_unique<UniformRender>(frame, kernel, plan, rays, true);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  Frame frame;
  frame.settings.width = 18;
  frame.settings.height = 10;
  frame.settings.rays_per_pixel = rays;
  Kernel kernel{};
  kernel.render_pixels = [](const Frame&, const FilmView&, const PixelSamples&, RayCounts&) {};
  const std::unique_ptr<ResumableRender> render = render_for(data[0], frame, kernel);
  const auto bytes = std::as_bytes(std::span(data + 1, size - 1));
  try {
    const Checkpoint checkpoint({bytes.begin(), bytes.end()}, "c");
    checkpoint.restore(*render);
  } catch (const FileError& error) {
    require(error.exit_code == 65 && std::string_view(error.what()).starts_with("`c` is "));
    return 0;
  }
  RenderState state;
  render->run(state);
  require(render->is_finished());
  require(!render->take_film().color().empty());
  return 0;
}
