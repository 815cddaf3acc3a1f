// Compiled once for each instruction set.
#include "probes/lane_probes.hpp"

#include "geometry/traversal.hpp"
#include "sampling/permutation.hpp"
#include "sampling/warp.hpp"
#include "tracing/texture.hpp"

namespace penumbra::PENUMBRA_KERNEL {
namespace {

void occluded_rays(const World& world, std::span<const ProbeRay> rays, std::span<bool> blocked) {
  for (std::size_t i = 0; i < rays.size();) {
    const ProbePacket packet = load_packet(&rays[i], rays.size() - i);
    const std::uint32_t lanes = bits(occluded(world, packet.rays, packet.farthest, packet.active));
    for (std::size_t lane = 0; lane < packet.size; lane++, i++) blocked[i] = (lanes >> lane) & 1;
  }
}

Floats evaluate_one(LaneFunction function, Floats a, Floats b, Floats c) {
  switch (function) {
    case LaneFunction::sine:
      return sincos_turns(a).sine;
    case LaneFunction::cosine:
      return sincos_turns(a).cosine;
    case LaneFunction::log2:
      return log2(a);
    case LaneFunction::exp2:
      return exp2(a);
    case LaneFunction::power:
      return pow(a, b);
    case LaneFunction::whole_power:
      return whole_power(a, truncate(b));
    case LaneFunction::common_power: {
      alignas(64) float exponent[lane_count];
      store(exponent, b);
      return whole_power(a, static_cast<std::uint32_t>(exponent[0]));
    }
    case LaneFunction::acos_turns:
      return acos_turns(a);
    case LaneFunction::disk_x:
      return warp_to_disk({a, b}).x;
    case LaneFunction::disk_y:
      return warp_to_disk({a, b}).y;
    case LaneFunction::ball_x:
      return warp_to_ball({a, b}, c).x;
    case LaneFunction::ball_y:
      return warp_to_ball({a, b}, c).y;
    case LaneFunction::ball_z:
      return warp_to_ball({a, b}, c).z;
    case LaneFunction::noise:
      return noise3({a, b, c});
    case LaneFunction::wood_red:
      return wood_color({a, b, c}).x;
    case LaneFunction::wood_green:
      return wood_color({a, b, c}).y;
    case LaneFunction::wood_blue:
      return wood_color({a, b, c}).z;
    case LaneFunction::marble:
      return marble_grey({a, b, c});
    case LaneFunction::stone_red:
      return stone_color({a, b, c}, Mask(true)).x;
    case LaneFunction::stone_green:
      return stone_color({a, b, c}, Mask(true)).y;
    case LaneFunction::stone_blue:
      return stone_color({a, b, c}, Mask(true)).z;
    case LaneFunction::stone_border:
      return stone_cell({a, b, c}, Mask(true)).border;
  }
  return Floats(0);
}

void evaluate(LaneFunction function, std::span<const float> a, std::span<const float> b, std::span<const float> c,
              std::span<float> out) {
  for (std::size_t i = 0; i < out.size(); i += lane_count) {
    alignas(64) float in[3][lane_count] = {};
    const std::size_t size = out.size() - i < lane_count ? out.size() - i : lane_count;
    for (std::size_t lane = 0; lane < size; lane++) {
      in[0][lane] = a[i + lane];
      in[1][lane] = b[i + lane];
      in[2][lane] = c[i + lane];
    }
    alignas(64) float result[lane_count];
    store(result, evaluate_one(function, load(in[0]), load(in[1]), load(in[2])));
    for (std::size_t lane = 0; lane < size; lane++) out[i + lane] = result[lane];
  }
}

void permute_all(std::span<std::uint32_t> index, std::uint32_t length, std::span<const std::uint32_t> key) {
  for (std::size_t i = 0; i < index.size(); i += lane_count) {
    alignas(64) std::uint32_t indices[lane_count] = {}, keys[lane_count] = {};
    const std::size_t size = index.size() - i < lane_count ? index.size() - i : lane_count;
    for (std::size_t lane = 0; lane < size; lane++) {
      indices[lane] = index[i + lane];
      keys[lane] = key[i + lane];
    }
    store(indices, permute(load(indices), length, load(keys)));
    for (std::size_t lane = 0; lane < size; lane++) index[i + lane] = indices[lane];
  }
}

}  // namespace

const LaneProbes probes = {occluded_rays, evaluate, permute_all};

}  // namespace penumbra::PENUMBRA_KERNEL
