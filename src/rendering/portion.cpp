#include "rendering/portion.hpp"

#include <algorithm>

namespace penumbra {
namespace {

constexpr std::uint32_t samples_of_packet = 32;
constexpr double rays_at_once = 1 << 19;

// The rays that a sample sends, roughly.
double rays_of_sample(const Frame& frame) {
  double at_eye = 1, deeper = 1;
  for (const FrameLight& light : frame.lights) {
    at_eye += light.kind == LightKind::disk ? frame.options.shadow_rays : 1;
    deeper += 1;
  }
  const TracingOptions& options = frame.options;
  const double branches = options.max_depth > 0 ? options.reflection_rays + options.transmission_rays : 0;
  return at_eye + branches * deeper * std::min(options.max_depth, 4);
}

}  // namespace

std::uint32_t Portion::end_after(std::uint32_t first, std::uint32_t end) const {
  const std::uint32_t aligned = first / samples_of_packet * samples_of_packet;
  return end - aligned > samples ? aligned + samples : end;
}

Portion portion_for(const Frame& frame, int width, int height) {
  const double samples = rays_at_once / rays_of_sample(frame);
  const auto packets = [&](int w, int h) { return samples / (double{samples_of_packet} * w * h); };
  while (height > 1 && packets(width, height) < 1) height /= 2;
  while (width > 1 && packets(width, height) < 1) width /= 2;
  const auto whole_packets = static_cast<std::uint32_t>(std::max(packets(width, height), 1.0));
  return {width, height, whole_packets * samples_of_packet};
}

bool render_portions(const FilmView& film, const Frame& frame, const Kernel& kernel, const Crop& pixels,
                     SampleRange range, RayCounts& counts, const RenderState& state) {
  const Portion portion = portion_for(frame, pixels.width(), pixels.height());
  for (std::uint32_t first = range.first; first < range.end;) {
    const std::uint32_t end = portion.end_after(first, range.end);
    for (int y = pixels.y0; y < pixels.y1; y += portion.height) {
      for (int x = pixels.x0; x < pixels.x1; x += portion.width) {
        if (state.stop.load(std::memory_order_relaxed)) return false;
        const int x1 = std::min(x + portion.width, pixels.x1), y1 = std::min(y + portion.height, pixels.y1);
        kernel.render_tile(frame, film, {x, y, x1, y1, first, end}, counts);
      }
    }
    first = end;
  }
  return true;
}

}  // namespace penumbra
