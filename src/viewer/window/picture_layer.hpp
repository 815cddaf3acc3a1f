// The picture itself, or two halves of two pictures with the divider between them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "image/image.hpp"
#include "image/quantize.hpp"
#include "viewer/session.hpp"

namespace penumbra {

// A picture as an OpenGL texture, with the numbers that a PNG would hold.
class PictureTexture {
 public:
  PictureTexture();
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  void load(const Image& image, double exposure, Rounding rounding);
  // Below a zoom of 1, pixels are blended; otherwise each is a square.
  void* id(double zoom) const;

 private:
  std::uint32_t texture_ = 0;
  std::vector<std::uint8_t> bytes_;
};

class PictureLayer {
 public:
  // Draws behind everything else.
  void draw(const Session& session);

 private:
  void load(const Session& session);

  PictureTexture textures_[2];
  std::shared_ptr<const Refinement> loaded_;
  int loaded_exposure_ = 0;
};

// Where the divider of the split view is, in pixels of the window from the left.
double divider_in_window(const Session& session);

}  // namespace penumbra
