// A picture in memory: plain data, no code that reads, writes or renders it. Colours are the numbers of the scene in
// float, unclamped; rows run from the top, and the window says which part of the full picture the pixels show.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/pixel_rect.hpp"
#include "base/zeroed_pages.hpp"

namespace penumbra {

// Colours of width x height pixels, row by row from the top, three floats per pixel: r, g, b.
struct Image {
  int width = 0, height = 0;
  ZeroedVector<float> rgb;

  bool operator==(const Image&) const = default;
};

// A black image.
inline Image make_image(int width, int height) {
  return {width, height, ZeroedVector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
}

// One more number per pixel of an image, row by row from the top: `depth.Z`, `normal.X`, ...
struct Channel {
  std::string name;
  ZeroedVector<float> values;

  bool operator==(const Channel&) const = default;
};

// Keys and values as text: the scene, the options that change the picture, the version. Keys have 1-60 letters, digits,
// `_` or `-`; values are UTF-8.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// A picture as a file holds it.
struct ImageFile {
  Image image;                          // the pixels of the window
  PixelRect window;                     // where they are in the full picture; not stored in a PNG
  int full_width = 0, full_height = 0;  // size of the full picture
  std::vector<Channel> layers;          // of the window's size; EXR only
  Metadata metadata;
};

// Whether the window differs from the full picture.
inline bool is_crop(const ImageFile& file) { return file.window != PixelRect{0, 0, file.full_width, file.full_height}; }

// The file for an image that is a full picture.
inline ImageFile whole_picture(Image image, Metadata metadata = {}) {
  const int width = image.width, height = image.height;
  return {std::move(image), {0, 0, width, height}, width, height, {}, std::move(metadata)};
}

}  // namespace penumbra
