// Some pixels of a tile, in the order in which they share packets.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "base/pixel_rect.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {

class PixelList {
 public:
  static constexpr std::size_t capacity = std::size_t{noise_tile_size} * noise_tile_size;

  void add(Pixel pixel) { pixels_[size_++] = pixel; }
  std::span<const Pixel> all() const { return {pixels_.data(), size_}; }

 private:
  std::array<Pixel, capacity> pixels_;
  std::size_t size_ = 0;
};

// The pixels of a tile that are `wanted(x, y)`, in Morton order: pixels that are close in the list are close in the
// picture, and if all are wanted, each aligned run of 2^k pixels is a square or two squares side by side.
template <class Wanted>
PixelList pixels_of(const PixelRect& tile, const Wanted& wanted) {
  PixelList list;
  const auto even_bits = [](unsigned v) { return (v & 1) | (v >> 1 & 2) | (v >> 2 & 4) | (v >> 3 & 8); };
  const unsigned side = std::bit_ceil(static_cast<unsigned>(std::max(tile.width(), tile.height())));
  for (unsigned i = 0; i < side * side; i++) {
    const int x = tile.x0 + static_cast<int>(even_bits(i)), y = tile.y0 + static_cast<int>(even_bits(i >> 1));
    if (x >= tile.x1 || y >= tile.y1 || !wanted(x, y)) continue;
    list.add({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
  }
  return list;
}

inline PixelList pixels_of(const PixelRect& tile) {
  return pixels_of(tile, [](int, int) { return true; });
}

}  // namespace penumbra
