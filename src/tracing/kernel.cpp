// Compiled once for each instruction set: everything per ray, behind the functions of one table.
#include "tracing/kernel.hpp"

#include "tracing/packets.hpp"

namespace penumbra::PENUMBRA_KERNEL {

namespace recording {
void record_sample(const Frame&, int x, int y, std::uint32_t sample, std::uint32_t count, const RayListener&);
}

namespace {

void render_pixels(const Frame& frame, const FilmView& film, const PixelSamples& wanted, RayCounts& counts) {
  PacketRenderer{frame, film, wanted, counts, {}}.render();
}

struct ProbePacket {
  Rays rays;
  Floats farthest;
  Mask active;
  std::size_t size;
};

ProbePacket load_packet(const ProbeRay* rays, std::size_t left) {
  alignas(64) float columns[8][lane_count] = {};
  const std::size_t size = left < lane_count ? left : lane_count;
  for (std::size_t i = 0; i < size; i++) {
    for (int axis = 0; axis < 3; axis++) {
      columns[axis][i] = rays[i].origin[axis];
      columns[3 + axis][i] = rays[i].direction[axis];
    }
    columns[6][i] = rays[i].time;
    columns[7][i] = rays[i].farthest;
  }
  ProbePacket packet;
  packet.rays.origin = {load(columns[0]), load(columns[1]), load(columns[2])};
  packet.rays.direction = {load(columns[3]), load(columns[4]), load(columns[5])};
  packet.rays.time = load(columns[6]);
  packet.rays.unit = false;
  packet.farthest = load(columns[7]);
  packet.active = mask_from_bits(0xffffffffu >> (32 - size));
  packet.size = size;
  return packet;
}

void probe_intersect(const World& world, std::span<const ProbeRay> rays, std::span<ProbeHit> hits) {
  for (std::size_t i = 0; i < rays.size();) {
    const ProbePacket packet = load_packet(&rays[i], rays.size() - i);
    const Hits found = intersect(world, packet.rays, packet.farthest, packet.active);
    alignas(64) float columns[7][lane_count];
    alignas(64) std::uint32_t surface[lane_count];
    store(columns[0], select(found.found, found.distance, Floats(__builtin_inff())));
    store(columns[1], found.normal.x);
    store(columns[2], found.normal.y);
    store(columns[3], found.normal.z);
    store(columns[4], found.point.x);
    store(columns[5], found.point.y);
    store(columns[6], found.point.z);
    store(surface, found.surface);
    for (std::size_t lane = 0; lane < packet.size; lane++, i++) {
      hits[i] = {columns[0][lane],
                 surface[lane],
                 {columns[1][lane], columns[2][lane], columns[3][lane]},
                 {columns[4][lane], columns[5][lane], columns[6][lane]}};
    }
  }
}

void probe_occluded(const World& world, std::span<const ProbeRay> rays, std::span<bool> blocked) {
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

Pair points_in(const Sampler& sampler, std::uint32_t dimension) {
  switch (dimension) {
    case pixel_x:
      return sampler.pixel_place();
    case lens_radius:
      return sampler.lens_place();
    case first_light_radius:
      return sampler.first_light_place();
    case shutter_time:
      return {sampler.time(), Floats(0)};
    default:
      return sampler.pair(dimension);
  }
}

void sample_points(const Frame& frame, int x, int y, std::uint32_t dimension, std::span<float> u, std::span<float> v) {
  const PixelSampler pixel(Ints(static_cast<std::uint32_t>(x)), Ints(static_cast<std::uint32_t>(y)),
                           frame.settings.seed);
  const PatternChoice pattern = frame.pattern_choice();
  for (std::size_t i = 0; i < u.size(); i += lane_count) {
    const Sampler sampler(pattern, pixel, static_cast<std::uint32_t>(i), lane_count);
    const Pair p = points_in(sampler, dimension);
    alignas(64) float result[2][lane_count];
    store(result[0], p.u);
    store(result[1], p.v);
    for (std::size_t lane = 0; lane < lane_count && i + lane < u.size(); lane++) {
      u[i + lane] = result[0][lane];
      v[i + lane] = result[1][lane];
    }
  }
}

constexpr const char* isa_name = vector_lanes == 16 ? "avx512" : vector_lanes == 8 ? "avx2" : "sse42";

}  // namespace

const Kernel kernel = {isa_name,        vector_lanes,   render_pixels, recording::record_sample,
                       probe_intersect, probe_occluded, evaluate,      sample_points};

}  // namespace penumbra::PENUMBRA_KERNEL
