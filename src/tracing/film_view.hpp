// What a kernel sees of a film: where the sums of samples go, and which samples of which pixels are wanted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace penumbra {

// Where a pixel is in the picture.
struct PixelPlace {
  std::uint32_t x, y;
};

// Where the sums of samples go: planes of doubles, `channels` numbers a pixel, row by row over the window that starts
// at (x0, y0); a plane that is not wanted is null. Every number is a whole multiple of its quantum before it is added,
// so that the sums are exact and do not depend on the order of the samples.
struct FilmView {
  double* color = nullptr;    // 3: r, g, b
  double* squares = nullptr;  // 3: of the same
  double* depth = nullptr;    // 2: distance along the view, number of samples that hit anything
  double* normal = nullptr;   // 3
  double* albedo = nullptr;   // 3
  int x0 = 0, y0 = 0, width = 0;

  // The number of a pixel of the window.
  std::size_t index_of(PixelPlace pixel) const {
    return static_cast<std::size_t>(static_cast<int>(pixel.y) - y0) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(static_cast<int>(pixel.x) - x0);
  }
};

// Samples first <= index < end of each of these pixels. Pixels that follow each other should be near each other: where
// few samples of each are wanted, they share packets.
struct PixelSamples {
  std::span<const PixelPlace> pixels;
  std::uint32_t first, end;
};

}  // namespace penumbra
