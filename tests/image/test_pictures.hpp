// Pictures for tests, made by integer formulas so that other programs can make the same ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "image/image.hpp"

namespace penumbra::test {

// Colours n/255 that vary in all directions; `shift` makes stripes of 8 columns differ from the picture with shift 0.
inline Image pattern(int width, int height, int shift = 0) {
  Image image = make_image(width, height);
  for (int y = 0, i = 0; y < height; y++) {
    for (int x = 0; x < width; x++) {
      const int stripe = (x / 8) % 2 * shift;
      image.rgb[static_cast<std::size_t>(i++)] = static_cast<float>((x * 5 + y * 3 + stripe) % 256) / 255.0f;
      image.rgb[static_cast<std::size_t>(i++)] = static_cast<float>((x * x + y + stripe) % 256) / 255.0f;
      image.rgb[static_cast<std::size_t>(i++)] = static_cast<float>((x ^ y) * 4 % 256) / 255.0f;
    }
  }
  return image;
}

inline Image flat(int width, int height, float r, float g, float b) {
  Image image = make_image(width, height);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    image.rgb[i] = r;
    image.rgb[i + 1] = g;
    image.rgb[i + 2] = b;
  }
  return image;
}

// Floats of every kind but NaN.
inline Image wild(int width, int height) {
  Image image = make_image(width, height);
  const float infinity = std::numeric_limits<float>::infinity();
  const float special[] = {0.0f, -0.0f, 1e-45f, -3.5f, 3e38f, infinity, -infinity, 1.0f / 3.0f};
  std::uint32_t state = 1;
  for (float& v : image.rgb) {
    state = state * 1664525u + 1013904223u;
    v = (state >> 28) == 0 ? special[state >> 8 & 7] : std::ldexp(static_cast<float>(state >> 8), -24) * 10.0f - 2.0f;
  }
  return image;
}

// A crop of a larger picture, with layers and metadata.
inline ImageFile crop_with_layers() {
  ImageFile file;
  file.image = wild(13, 9);
  file.window = {5, 7, 18, 16};
  file.full_width = 40;
  file.full_height = 30;
  const auto layer = [&](const char* name, float factor) {
    Channel channel{name, {}};
    for (std::size_t i = 0; i < file.image.rgb.size(); i += 3) channel.values.push_back(file.image.rgb[i] * factor);
    return channel;
  };
  file.layers = {layer("depth.Z", 10), layer("normal.X", 0.5f), layer("normal.Y", 0.25f), layer("samples", -1)};
  file.metadata = {{"options", "--rays 16 --seed 3"}, {"scene", "s\xc3\xbc\xc3\x9f.cli"}, {"version", "0.1.0"}};
  return file;
}

}  // namespace penumbra::test
