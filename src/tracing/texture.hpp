// The solid textures: each gives the diffuse colour of a point of the block that it is cut from.
#pragma once

#include "tracing/frame.hpp"
#include "tracing/marble.hpp"
#include "tracing/stone.hpp"
#include "tracing/wood.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Defined in the lanes given, and on surfaces that have a texture.
PENUMBRA_INLINE Float3 texture_color(const FrameSurface& s, Mask lanes, Float3 p) {
  const auto grey = [](Floats value) { return Float3{value, value, value}; };
  switch (s.texture) {
    case Texture::none:
      break;
    case Texture::noise:
      return grey(noise3(p * Floats(s.texture_scale)));
    case Texture::wood:
      return wood_color(p);
    case Texture::marble:
      return grey(marble_grey(p));
    case Texture::stone:
      return stone_color(p, lanes);
  }
  return broadcast3(s.diffuse);
}

}  // namespace penumbra::PENUMBRA_KERNEL
