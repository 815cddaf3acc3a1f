// What a kernel sees of a film: where the sums of samples go, and which samples of which pixels are wanted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/pixel_rect.hpp"
#include "tracing/layers.hpp"

namespace penumbra {

// The sums of one layer: so many doubles a pixel, row by row over the film's pixels.
struct FilmPlane {
  Layer layer;
  int sums_per_pixel;
  double* sums;

  double* of_pixel(std::size_t pixel) const { return sums + static_cast<std::size_t>(sums_per_pixel) * pixel; }
};

// Every number is a whole multiple of its quantum before it is added, so that the sums are exact and do not depend on
// the order of the samples.
struct FilmView {
  PixelRect pixels;
  FilmPlane planes[layer_count];  // those of the layers to add to, in the order of the table: the colour's first
  std::size_t plane_count = 0;

  void add(FilmPlane plane) { planes[plane_count++] = plane; }
  const FilmPlane& color() const { return planes[0]; }
  std::span<const FilmPlane> all() const { return {planes, plane_count}; }
};

// Samples first <= index < end of each of these pixels. Pixels that follow each other should be near each other: where
// few samples of each are wanted, they share packets.
struct PixelSamples {
  std::span<const Pixel> pixels;
  std::uint32_t first, end;
  const std::atomic<bool>* given_up = nullptr;  // once it is set, the film gets anything: nobody wants these samples
};

}  // namespace penumbra
