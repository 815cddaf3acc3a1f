// Which picture sizes are plausible: a damaged or hostile file must not make the program allocate memory that its
// pixels could never fill.
#pragma once

#include <cstddef>
#include <cstdint>

#include "image/image.hpp"

namespace penumbra {

constexpr int largest_image_side = 1 << 17;

constexpr bool is_possible_size(std::int64_t width, std::int64_t height) {
  return width > 0 && height > 0 && width <= largest_image_side && height <= largest_image_side &&
         width * height <= most_pixels;
}

// Whether a file of `file_bytes` can hold a picture of this size that takes `raw_bytes` before compression by Deflate,
// which compresses at most by a factor of 1032 (RFC 1951: 258 bytes from two bits at best). In memory, each of the
// `values_per_pixel` takes four bytes, even if the file has one bit for it, or compresses better than Deflate: where
// that is much, at least a byte for each has to fit.
constexpr bool is_plausible_size(std::int64_t width, std::int64_t height, std::uint64_t raw_bytes,
                                 std::uint64_t values_per_pixel, std::size_t file_bytes) {
  constexpr std::uint64_t best_factor = 1032, harmless_values = std::uint64_t{1} << 26;
  if (!is_possible_size(width, height) || raw_bytes / best_factor > file_bytes) return false;
  const std::uint64_t values = static_cast<std::uint64_t>(width * height) * values_per_pixel;
  return values <= harmless_values || values / best_factor <= file_bytes;
}

// Throws FileError 70 if the picture is empty or beyond the limits, or does not have `values_per_pixel` values for
// every pixel.
void require_image_size(int width, int height, std::size_t value_count, int values_per_pixel);

// Throws FileError 70 unless all keys are as image.hpp says: other programs would refuse or truncate them.
void require_metadata_keys(const Metadata& metadata);

}  // namespace penumbra
