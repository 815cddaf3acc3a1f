// The picture itself, or two halves of two pictures with the divider between them.
#pragma once

#include <memory>

#include "viewer/session.hpp"
#include "viewer/window/picture_texture.hpp"

namespace penumbra {

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
