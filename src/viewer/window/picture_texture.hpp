// A picture as an OpenGL texture, with the numbers that a PNG would hold.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"

namespace penumbra {

class PictureTexture {
 public:
  PictureTexture();
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  void load(const Image& image, double exposure, Rounding rounding);
  // Below a zoom of 1, pixels are blended; otherwise each is a square.
  void* id(double zoom) const;
  bool empty() const { return width_ == 0; }

 private:
  std::uint32_t texture_ = 0;
  int width_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace penumbra
