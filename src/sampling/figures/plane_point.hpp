// A point of the unit square, in double precision: what the figures of a sample pattern are computed from.
#pragma once

namespace penumbra {

struct PlanePoint {
  double x = 0, y = 0;  // in [0, 1)
};

}  // namespace penumbra
