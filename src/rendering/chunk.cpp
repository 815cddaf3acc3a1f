#include "rendering/chunk.hpp"

#include <bit>

namespace penumbra {
namespace {

constexpr std::uint32_t samples_of_packet = 32;
constexpr double rays_at_once = 1 << 19;

// A rough count of the rays that a sample sends.
double rays_of_sample(const Frame& frame) {
  double at_eye = 1, deeper = 1;
  for (const FrameLight& light : frame.lights) {
    at_eye += light.has_area ? frame.settings.shadow_rays : 1;
    deeper += 1;
  }
  if (frame.light_rays > 0) at_eye = deeper = 1 + frame.light_rays;
  const Settings& settings = frame.settings;
  const double branches = settings.max_depth > 0 ? settings.reflection_rays + settings.transmission_rays : 0;
  return at_eye + branches * deeper * std::min(settings.max_depth, 4);
}

}  // namespace

ChunkSize chunk_size(const Frame& frame, std::size_t pixels, std::uint32_t fewest_samples) {
  pixels = std::bit_ceil(pixels);
  const double samples = rays_at_once / rays_of_sample(frame);
  const auto packets = [&] { return samples / (double{samples_of_packet} * static_cast<double>(pixels)); };
  const double fewest_packets = std::max(static_cast<double>(fewest_samples) / samples_of_packet, 1.0);
  while (pixels > 1 && packets() < fewest_packets) pixels /= 2;
  return {pixels, static_cast<std::uint32_t>(std::max(packets(), 1.0)) * samples_of_packet};
}

std::uint32_t Chunk::end_after(std::uint32_t first, std::uint32_t end) const {
  const std::uint32_t aligned = first / samples_of_packet * samples_of_packet;
  return end - aligned > samples ? aligned + samples : end;
}

}  // namespace penumbra
