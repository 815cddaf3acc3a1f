// Where the inspector of a pixel lies: over the edge of the picture that is farther from the pixel.
#pragma once

#include "viewer/picture_view.hpp"

namespace penumbra {

// A strip along the top or the bottom of the view's area, `margin` pixels inside it and at most `most` pixels high. It
// covers no more than a third of what is seen of the picture. `pixel`: the place of the pixel in the window.
WindowArea inspector_area(const PictureView& view, PlaceInWindow pixel, int margin, int most);

}  // namespace penumbra
