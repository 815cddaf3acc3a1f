// Compiled once for each instruction set: everything per ray, behind the functions of one table.
#include "tracing/kernel.hpp"

#include "tracing/packets.hpp"
#include "tracing/probe.hpp"

namespace penumbra::PENUMBRA_KERNEL {

namespace recording {
std::array<float, 3> record_sample(const Frame&, int x, int y, std::uint32_t sample, std::uint32_t count,
                                   const RayListener&);
}

namespace {

void render_pixels(const Frame& frame, const FilmView& film, const PixelSamples& wanted, RayCounts& counts) {
  OpenPackets open(frame);
  PacketRenderer{frame, film, wanted, counts, {}, open}.render();
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

const Kernel kernel = {isa_name, vector_lanes, render_pixels, recording::record_sample, probe_intersect, sample_points};

}  // namespace penumbra::PENUMBRA_KERNEL
