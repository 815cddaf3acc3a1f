// Samples of pixels, cut into packets. A packet is W samples of one pixel; where fewer are left, or fewer were asked
// for, it is S samples each of W/S pixels. With an Embree mesh in view, whose answers can depend on who shares one of
// its packets, S is at least what Embree takes at once.
#pragma once

#include <algorithm>
#include <bit>

#include "tracing/eye_rays.hpp"
#include "tracing/film_packet.hpp"
#include "tracing/trace.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Samples of a packet, and what their trees bring.
struct TracedPacket {
  Ints column, row;
  std::uint32_t first;  // lane k is sample first + k % samples_per_pixel
  int samples_per_pixel;
  Mask active;
  // What the trees bring; not defined before.
  Rays rays;
  FirstHits first_hits;
  Float3 color;

  PENUMBRA_INLINE TracedPacket() {}
  PENUMBRA_INLINE TracedPacket(Ints x, Ints y, std::uint32_t first_sample, int samples, Mask lanes)
      : column(x), row(y), first(first_sample), samples_per_pixel(samples), active(lanes) {}
};

// Packets whose lone rays are still on their way.
struct OpenPackets {
  struct Packet {
    TracedPacket traced;
    std::span<const Pixel> pixels;
  };
  LoneRays lone_rays;
  Packet packets[LoneRays::most_packets];
  std::uint32_t count = 0;

  OpenPackets(const Frame& frame)
      : lone_rays(frame.color_quantum, frame.chooses_branches, !records && frame.world.meshes.empty()) {}
};

struct PacketRenderer {
  const Frame& frame;
  const FilmView& film;
  const PixelSamples& wanted;
  RayCounts& counts;
  [[no_unique_address]] Recorder recorder;
  OpenPackets& open;
  PatternChoice pattern = frame.pattern_choice();
  float quanta = static_cast<float>(1 / frame.color_quantum);  // of a colour of 1

  PENUMBRA_INLINE bool color_alone() const { return film.plane_count == 1; }

  PENUMBRA_INLINE TraceContext context(const Sampler& sampler) const {
    return {frame, sampler, counts, open.lone_rays, wanted.given_up, recorder};
  }

  // Traces the trees of the samples of one packet.
  PENUMBRA_INLINE void trace_packet(const PixelSampler& pixel, TracedPacket& packet) const {
    const Sampler sampler(pattern, pixel, packet.first, packet.samples_per_pixel);
    packet.rays = eye_rays(frame, sampler, to_floats(packet.column), to_floats(packet.row), packet.active);
    packet.rays.given_up = wanted.given_up;
    counts[RayKind::eye] += static_cast<std::uint64_t>(count(packet.active));
    packet.color =
        trace(context(sampler), packet.rays, packet.active, TreeNode{}, color_alone() ? nullptr : &packet.first_hits);
  }

  // Adds the samples of a packet to `sums`.
  PENUMBRA_INLINE void add_packet(const TracedPacket& packet, Float3 color, PixelSums& sums) const {
    const Mask active = packet.active;
    recorder.samples(color);
    if (color_alone() && sums.color.add(keep(active, color), quanta)) return;
    const Mask x = is_finite_sample(color.x), y = is_finite_sample(color.y), z = is_finite_sample(color.z);
    if (const Mask wrong = active & ~(x & y & z); any(wrong)) {
      note_not_finite(wrong, packet.column, packet.row, packet.first, packet.samples_per_pixel);
      const Floats largest = Floats(frame.largest_color);
      color = {select(x, color.x, largest), select(y, color.y, largest), select(z, color.z, largest)};
    }
    sums.add(PacketResult(frame, film, active, color, packet.first_hits, packet.rays));
  }

  // Where rays go on alone, packets stay open until there are some of them.
  void open_packet(const PixelSampler& pixel, std::span<const Pixel> pixels, const TracedPacket& packet) const {
    OpenPackets::Packet& last = open.packets[open.count++];
    last.traced = packet;
    last.pixels = pixels;
    trace_packet(pixel, last.traced);
    if (!open.lone_rays.next_packet()) close_packets();
  }
  void close_packets() const {
    if (open.count == 0) return;
    const PixelSampler any_pixel(0u, 0u, 0u);
    trace_waiting(context(Sampler(pattern, any_pixel, 0, lane_count)));
    for (std::uint32_t i = 0; i < open.count; i++) {
      const auto& [packet, pixels] = open.packets[i];
      PixelSums sums;
      add_packet(packet, open.lone_rays.with_light(i, packet.color), sums);
      add_to_film(frame, film, pixels, sums, packet.samples_per_pixel);
    }
    open.count = 0;
    open.lone_rays.open();
  }

  // Counts the samples of a packet that are not finite.
  [[gnu::cold, gnu::noinline]] void note_not_finite(Mask wrong, Ints column, Ints row, std::uint32_t first,
                                                    int samples_per_pixel) const {
    alignas(64) std::uint32_t x[lane_count], y[lane_count];
    store(x, column);
    store(y, row);
    for (std::uint32_t lane = 0; lane < lane_count; lane++) {
      if ((bits(wrong) >> lane & 1) == 0) continue;
      counts.not_finite += {1, x[lane], y[lane], first + lane % static_cast<std::uint32_t>(samples_per_pixel)};
    }
  }

  PENUMBRA_INLINE Mask samples_wanted(std::uint32_t first, int samples_per_pixel) const {
    const Ints index = (lane_numbers() & Ints(static_cast<std::uint32_t>(samples_per_pixel - 1))) + Ints(first);
    return ~(index < Ints(wanted.first)) & (index < Ints(wanted.end));
  }

  // Whole packets first <= index < end of every pixel.
  void render_wide(std::uint32_t first, std::uint32_t end) const {
    for (const Pixel& pixel : wanted.pixels) {
      const Ints column(pixel.x), row(pixel.y);
      const PixelSampler sampler(pixel.x, pixel.y, frame.settings.seed);
      PixelSums sums;
      for (std::uint32_t index = first; index < end; index += lane_count) {
        TracedPacket packet{column, row, index, lane_count, samples_wanted(index, lane_count)};
        if (frame.chooses_branches) {
          open_packet(sampler, {&pixel, 1}, packet);
          continue;
        }
        trace_packet(sampler, packet);
        add_packet(packet, packet.color, sums);
      }
      if (!frame.chooses_branches) add_to_film(frame, film, {&pixel, 1}, sums, lane_count);
    }
  }

  // S samples from `first` on of every pixel; S is a power of two below W that divides `first`.
  void render_narrow(std::uint32_t first, int samples) const {
    const std::size_t pixels_at_once = static_cast<std::size_t>(lane_count / samples);
    const Ints pixel_of_lane = lane_numbers() >> std::countr_zero(static_cast<unsigned>(samples));
    for (std::size_t next = 0; next < wanted.pixels.size(); next += pixels_at_once) {
      const auto pixels = wanted.pixels.subspan(next, std::min(pixels_at_once, wanted.pixels.size() - next));
      const Mask inside = pixel_of_lane < Ints(static_cast<std::uint32_t>(pixels.size()));
      const auto of_pixels = [&](std::uint32_t Pixel::*coordinate) {
        if (samples == vector_lanes) return halves(pixels.front().*coordinate, pixels.back().*coordinate);
        return gather(&(pixels.front().*coordinate), select(inside, pixel_of_lane, Ints(0u)) << 1);  // in words
      };
      const Ints column = of_pixels(&Pixel::x), row = of_pixels(&Pixel::y);
      const PixelSampler sampler(column, row, frame.settings.seed);
      TracedPacket packet{column, row, first, samples, inside & samples_wanted(first, samples)};
      if (frame.chooses_branches) {
        open_packet(sampler, pixels, packet);
        continue;
      }
      PixelSums sums;
      trace_packet(sampler, packet);
      add_packet(packet, packet.color, sums);
      add_to_film(frame, film, pixels, sums, samples);
    }
  }

  void render() const {
    // With a mesh in view, each half of a packet belongs to one pixel.
    const std::uint32_t fewest = frame.world.meshes.empty() ? 1 : vector_lanes;
    std::uint32_t index = wanted.first;
    while (index < wanted.end) {
      const std::uint32_t first = index - index % fewest;
      const std::uint32_t left = wanted.end - first;
      const std::uint32_t alignment = first % lane_count == 0 ? lane_count : first & -first;
      std::uint32_t samples = fewest;
      while (samples < left && samples < alignment) samples *= 2;
      std::uint32_t end = first + samples;
      if (samples == lane_count) {
        end = first + std::max(left / lane_count, 1u) * lane_count;
        render_wide(first, end);
      } else {
        render_narrow(first, static_cast<int>(samples));
      }
      index = std::min(end, wanted.end);
    }
    close_packets();
  }
};

}  // namespace penumbra::PENUMBRA_KERNEL
