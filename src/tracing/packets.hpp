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

struct PacketRenderer {
  const Frame& frame;
  const FilmView& film;
  const PixelSamples& wanted;
  RayCounts& counts;
  [[no_unique_address]] Recorder recorder;
  PatternChoice pattern = frame.pattern_choice();
  float quanta = static_cast<float>(1 / frame.color_quantum);  // of a colour of 1

  // Traces the samples of one packet into `sums`.
  PENUMBRA_INLINE void add_packet(const PixelSampler& pixel, Ints column, Ints row, std::uint32_t first,
                                  int samples_per_pixel, Mask active, PixelSums& sums) const {
    const Sampler sampler(pattern, pixel, first, samples_per_pixel);
    Rays rays = eye_rays(frame, sampler, to_floats(column), to_floats(row), active);
    rays.given_up = wanted.given_up;
    counts[RayKind::eye] += static_cast<std::uint64_t>(count(active));
    const TraceContext context{frame, sampler, counts, recorder};
    FirstHits first_hits;
    const bool color_alone = film.plane_count == 1;
    Float3 color = trace(context, rays, active, 0, tree_root, color_alone ? nullptr : &first_hits);
    if (color_alone && sums.color.add(keep(active, color), quanta)) return;
    const Mask x = is_finite_sample(color.x), y = is_finite_sample(color.y), z = is_finite_sample(color.z);
    if (const Mask wrong = active & ~(x & y & z); any(wrong)) {
      note_not_finite(wrong, column, row, first, samples_per_pixel);
      const Floats largest = Floats(frame.largest_color);
      color = {select(x, color.x, largest), select(y, color.y, largest), select(z, color.z, largest)};
    }
    sums.add(PacketResult(frame, film, active, color, first_hits, rays));
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
        add_packet(sampler, column, row, index, lane_count, samples_wanted(index, lane_count), sums);
      }
      add_to_film(frame, film, {&pixel, 1}, sums, lane_count);
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
      PixelSums sums;
      add_packet(sampler, column, row, first, samples, inside & samples_wanted(first, samples), sums);
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
  }
};

}  // namespace penumbra::PENUMBRA_KERNEL
