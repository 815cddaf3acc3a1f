// The samples of a tile of pixels, cut into packets. A packet is W samples of one pixel; where fewer are left, or fewer
// were asked for, it is S samples each of W/S neighbouring pixels. With an Embree mesh in view, whose answers can
// depend on who shares one of its packets, S is at least what Embree takes at once.
#pragma once

#include <algorithm>

#include "tracing/eye_rays.hpp"
#include "tracing/film_packet.hpp"
#include "tracing/trace.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct TileRenderer {
  const Frame& frame;
  const FilmView& film;
  const TileSamples& tile;
  RayCounts& counts;
  RayRecorder* recorder = nullptr;
  PatternChoice pattern = frame.pattern_choice();
  float quanta = static_cast<float>(1 / frame.color_quantum);  // of a colour of 1

  // Traces the samples of one packet into `sums`.
  PENUMBRA_INLINE void add_packet(const PixelSampler& pixel, Ints column, Ints row, std::uint32_t first,
                                  int samples_per_pixel, Mask active, PixelSums& sums) const {
    const Sampler sampler(pattern, pixel, first, samples_per_pixel);
    const Rays rays = eye_rays(frame, sampler, to_floats(column), to_floats(row), active);
    counts.camera += static_cast<std::uint64_t>(count(active));
    const TraceContext context{frame, sampler, counts, recorder};
    FirstHits first_hits;
    const bool wants_first = film.depth || film.normal || film.albedo;
    const Float3 color = trace(context, rays, active, 0, tree_root, wants_first ? &first_hits : nullptr);
    const bool wants_more = wants_first || film.squares;
    if (!wants_more && sums.color.add(keep(active, color), quanta)) return;
    sums.add(PacketResult(frame, film, active, color, first_hits, rays));
  }

  PENUMBRA_INLINE Mask samples_wanted(std::uint32_t first, int samples_per_pixel) const {
    const Ints index = (lane_numbers() & Ints(static_cast<std::uint32_t>(samples_per_pixel - 1))) + Ints(first);
    return ~(index < Ints(tile.first)) & (index < Ints(tile.end));
  }

  // Whole packets first <= index < end of every pixel.
  void render_wide(std::uint32_t first, std::uint32_t end) const {
    for (int y = tile.y0; y < tile.y1; y++) {
      for (int x = tile.x0; x < tile.x1; x++) {
        const Ints column(static_cast<std::uint32_t>(x));
        const Ints row(static_cast<std::uint32_t>(y));
        const PixelSampler pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), frame.options.seed);
        PixelSums sums;
        for (std::uint32_t index = first; index < end; index += lane_count) {
          add_packet(pixel, column, row, index, lane_count, samples_wanted(index, lane_count), sums);
        }
        add_to_film(frame, film, x, y, sums, 0, lane_count);
      }
    }
  }

  // S samples from `first` on of every pixel; S is a power of two below W that divides `first`.
  void render_narrow(std::uint32_t first, int samples) const {
    const int pixels = lane_count / samples;
    const int block_width = pixels >= 8 ? 4 : pixels >= 2 ? 2 : 1;
    const int block_height = pixels / block_width;
    alignas(64) std::uint32_t columns[lane_count], rows[lane_count];
    for (int y = tile.y0; y < tile.y1; y += block_height) {
      for (int x = tile.x0; x < tile.x1; x += block_width) {
        std::uint32_t inside = 0;
        for (int lane = 0; lane < lane_count; lane++) {
          const int px = x + lane / samples % block_width;
          const int py = y + lane / samples / block_width;
          columns[lane] = static_cast<std::uint32_t>(px);
          rows[lane] = static_cast<std::uint32_t>(py);
          if (px < tile.x1 && py < tile.y1) inside |= 1u << lane;
        }
        const Ints column = load(columns);
        const Ints row = load(rows);
        const PixelSampler pixel(column, row, frame.options.seed);
        PixelSums sums;
        add_packet(pixel, column, row, first, samples, mask_from_bits(inside) & samples_wanted(first, samples), sums);
        for (int lane = 0; lane < lane_count; lane += samples) {
          if (!(inside >> lane & 1)) continue;
          add_to_film(frame, film, static_cast<int>(columns[lane]), static_cast<int>(rows[lane]), sums, lane, samples);
        }
      }
    }
  }

  void render() const {
    // With a mesh in view, each half of a packet belongs to one pixel.
    const std::uint32_t fewest = frame.world.meshes.empty() ? 1 : vector_lanes;
    std::uint32_t index = tile.first;
    while (index < tile.end) {
      const std::uint32_t first = index - index % fewest;
      const std::uint32_t left = tile.end - first;
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
      index = std::min(end, tile.end);
    }
  }
};

}  // namespace penumbra::PENUMBRA_KERNEL
