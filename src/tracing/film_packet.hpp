// From lanes to pixels: the only place where lanes meet. Each number is rounded to its quantum, so that sums are exact
// in double precision and no order of samples, packets or passes shows in the picture.
#pragma once

#include <algorithm>

#include "tracing/trace.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Mask is_finite_sample(Floats value) { return abs(value) <= Floats(largest_finite_sample); }

// The results of one packet of samples: what it adds to each sum of a pixel, plane by plane.
struct PacketResult {
  alignas(64) float values[most_sums][lane_count];
  double round[most_sums];
  bool squared[most_sums];  // whether it is the square of the value that is added
  int sums = 0;

  PENUMBRA_INLINE void add(Floats value, double quantum, bool square = false) {
    // What is not a finite number would spoil its pixel for good.
    store(values[sums], keep(is_finite_sample(value), value));
    squared[sums] = square;
    round[sums++] = rounder(quantum);
  }
  PENUMBRA_INLINE void add(Float3 value, double quantum, bool square = false) {
    add(value.x, quantum, square);
    add(value.y, quantum, square);
    add(value.z, quantum, square);
  }

  PENUMBRA_INLINE PacketResult(const Frame& frame, const FilmView& film, Mask active, Float3 color,
                               const FirstHits& first, const Rays& rays) {
    constexpr double unit_quantum = 1.0 / (1 << 30);  // of what is at most 1
    const Mask hit = active & first.found;
    for (const FilmPlane& plane : film.all()) {
      switch (plane.layer) {
        case Layer::color:
          add(keep(active, color), frame.color_quantum);
          break;
        case Layer::depth: {
          const Float3 way = rays.origin + rays.direction * first.distance - broadcast3(frame.camera.eye);
          add(keep(hit, dot(way, broadcast3(frame.camera.view))), frame.depth_quantum);
          add(keep(hit, Floats(1)), unit_quantum);
          break;
        }
        case Layer::normal:
          add(keep(hit, first.normal), unit_quantum);
          break;
        case Layer::albedo:
          add(keep(hit, first.albedo), frame.color_quantum);
          break;
        case Layer::variance:
          add(keep(active, color), frame.color_quantum, true);
          break;
        case Layer::samples:  // has no sums
          break;
      }
    }
  }
};

// For each four lanes side by side, in each of them, their sum.
PENUMBRA_INLINE Ints sums_of_fours(Ints a) {
  a += pick_bytes(a, sixteen_bytes(0x07060504u, 0x03020100u, 0x0f0e0d0cu, 0x0b0a0908u));
  return a + pick_bytes(a, sixteen_bytes(0x0b0a0908u, 0x0f0e0d0cu, 0x03020100u, 0x07060504u));
}

// The colours of packets in whole quanta, which takes a third of the work of doubles.
struct ColorQuanta {
  static constexpr float largest = 1 << quantum_bits;  // what a colour may have
  static constexpr int most_packets = 7;               // their sums still fit 31 bits
  Ints sums[3]{0u, 0u, 0u};
  int packets = 0;
  std::int64_t spilled[3] = {0, 0, 0};  // of all lanes of earlier packets

  // Adds the colours of one more packet; not if one of them is too large, or no number.
  PENUMBRA_INLINE bool add(Float3 color, float quanta) {
    const Float3 scaled = color * Floats(quanta);
    // As words, what is no number is larger than all numbers.
    const Ints size = max(max(as_ints(abs(scaled.x)), as_ints(abs(scaled.y))), as_ints(abs(scaled.z)));
    if (any(as_ints(Floats(largest)) < size)) return false;
    if (packets == most_packets) spill();
    sums[0] += truncate(round(scaled.x));
    sums[1] += truncate(round(scaled.y));
    sums[2] += truncate(round(scaled.z));
    packets++;
    return true;
  }

  // The sums of all packets for groups of lanes that lie side by side. Of a single packet, four lanes at once are added
  // first: their sum still fits 32 bits.
  template <int at_once>
  struct Groups {
    alignas(64) std::uint32_t sums[3][lane_count];
    std::int64_t spilled[3];

    PENUMBRA_INLINE explicit Groups(const ColorQuanta& quanta) {
      for (int c = 0; c < 3; c++) {
        store(sums[c], at_once == 4 ? sums_of_fours(quanta.sums[c]) : quanta.sums[c]);
        spilled[c] = quanta.spilled[c];
      }
    }

    PENUMBRA_INLINE std::int64_t sum(int channel, int first, int lanes) const {
      std::int64_t sum = spilled[channel];
      for (int i = first; i < first + lanes; i += at_once) sum += static_cast<std::int32_t>(sums[channel][i]);
      return sum;
    }
  };

 private:
  PENUMBRA_INLINE void spill() {
    const Groups<1> all(*this);
    for (int c = 0; c < 3; c++) {
      spilled[c] = all.sum(c, 0, lane_count);
      sums[c] = Ints(0u);
    }
    packets = 0;
  }
};

// The sums of the samples of one pixel, or of one packet of several pixels, lane by lane.
struct PixelSums {
  ColorQuanta color;
  bool has_values = false;  // whether there is anything but `color`
  alignas(64) double values[most_sums][lane_count];

  PENUMBRA_INLINE void add(const PacketResult& packet) {
    if (!has_values) {
      for (int i = 0; i < packet.sums; i++) std::fill_n(values[i], lane_count, 0.0);
    }
    has_values = true;
    for (int i = 0; i < packet.sums; i++) {
      const double round = packet.round[i], square_round = squares_rounder(round);
      const auto add_all = [&](const auto& term) {
        for (int lane = 0; lane < lane_count; lane++) {
          values[i][lane] += term((double{packet.values[i][lane]} + round) - round);
        }
      };
      if (packet.squared[i]) {
        add_all([=](double value) { return (value * value + square_round) - square_round; });
      } else {
        add_all([](double value) { return value; });
      }
    }
  }

  // The quantum of squares: 2^-30 of the square of the largest colour, which the colour's own quantum tells.
  static PENUMBRA_INLINE double squares_rounder(double round) {
    return round * (round * (double{1 << (2 * quantum_bits - 30)} / 6755399441055744.0));
  }
};

// The sum of `count` numbers, a power of two. It is exact, so that halves may be added to halves.
PENUMBRA_INLINE double sum_of_lanes(const double* values, int count) {
  if (count == 1) return values[0];
  double part[lane_count];
  for (int i = 0; i < count; i++) part[i] = values[i];
  for (int half = count / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; i++) part[i] += part[i + half];
  }
  return part[0];
}

// Adds the sums to the film: `lanes` lanes belong to each of the pixels.
PENUMBRA_INLINE void add_to_film(const Frame& frame, const FilmView& film, std::span<const Pixel> pixels,
                                 const PixelSums& sums, int lanes) {
  const auto add_colors = [&](const auto& groups) {
    for (std::size_t i = 0; i < pixels.size(); i++) {
      double* const color = film.color().of_pixel(film.pixels.index_of(pixels[i]));
      for (int c = 0; c < 3; c++) {
        const std::int64_t sum = groups.sum(c, static_cast<int>(i) * lanes, lanes);
        color[c] += static_cast<double>(sum) * frame.color_quantum;
      }
    }
  };
  if (lanes < lane_count && lanes % 4 == 0) {
    add_colors(ColorQuanta::Groups<4>(sums.color));
  } else {
    add_colors(ColorQuanta::Groups<1>(sums.color));
  }
  if (!sums.has_values) return;
  const double(*values)[lane_count] = sums.values;
  for (const FilmPlane& plane : film.all()) {
    for (std::size_t i = 0; i < pixels.size(); i++) {
      double* const pixel = plane.of_pixel(film.pixels.index_of(pixels[i]));
      const std::size_t first = i * static_cast<std::size_t>(lanes);
      for (int c = 0; c < plane.sums_per_pixel; c++) pixel[c] += sum_of_lanes(values[c] + first, lanes);
    }
    values += plane.sums_per_pixel;
  }
}

}  // namespace penumbra::PENUMBRA_KERNEL
