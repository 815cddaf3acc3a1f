// Classic Perlin noise in three dimensions (Perlin 1985, 2002): Perlin's permutation, twelve edge gradients, quintic
// fade, with the order of axes and gradients of Gustavson, "Simplex noise demystified" (2005), which the course's
// pictures show. The lattice cell of an exact whole number is the one below it for x <= 0 (the course's fast floor).
#pragma once

#include "base/lane_math.hpp"
#include "tracing/noise_permutation.hpp"

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Floats fade(Floats t) { return t * t * t * (t * (t * Floats(6) - Floats(15)) + Floats(10)); }

PENUMBRA_INLINE Floats lerp(Floats t, Floats a, Floats b) { return a + t * (b - a); }

struct Cell {
  Ints number;      // modulo 256
  Floats fraction;  // of the point in it
};

PENUMBRA_INLINE Cell noise_cell(Floats x) {
  const Ints whole = truncate(x);
  const Ints below = select(x > Floats(0), whole, whole - Ints(1));
  return {below & Ints(255), x - to_floats(below)};
}

// The gradient of a lattice corner times the way from it. The gradients are (+-1, +-1, 0), (+-1, 0, +-1), (0, +-1,
// +-1): four of each in turn, the first sign in the lowest bit.
PENUMBRA_INLINE Floats corner_noise(Ints corner, Floats x, Floats y, Floats z) {
  const Ints gradient = gather(noise_gradient, corner);
  const Floats u = select(gradient < Ints(8), x, y);
  const Floats v = select(gradient < Ints(4), y, z);
  return as_floats(as_ints(u) ^ (gradient << 31)) + as_floats(as_ints(v) ^ ((gradient & Ints(2)) << 30));
}

// Signed noise, about -1..1, of a point; it is 0 at whole numbers.
inline Floats noise3(Float3 p) {
  const Cell cx = noise_cell(p.x), cy = noise_cell(p.y), cz = noise_cell(p.z);
  const Floats x = cx.fraction, y = cy.fraction, z = cz.fraction;
  const Floats one = Floats(1);
  const Ints near = gather(noise_permutation, cz.number);
  const Ints far = gather(noise_permutation, cz.number + Ints(1));
  const auto corners = [&](Ints plane, int up) {
    return gather(noise_permutation, plane + cy.number + Ints(static_cast<std::uint32_t>(up))) + cx.number;
  };
  const Floats u = fade(x), v = fade(y), w = fade(z);
  const auto edge = [&](Ints corner, Floats dy, Floats dz) {
    return lerp(u, corner_noise(corner, x, dy, dz), corner_noise(corner + Ints(1), x - one, dy, dz));
  };
  const Floats front = lerp(v, edge(corners(near, 0), y, z), edge(corners(near, 1), y - one, z));
  const Floats back = lerp(v, edge(corners(far, 0), y, z - one), edge(corners(far, 1), y - one, z - one));
  return lerp(w, front, back);
}

}  // namespace penumbra::PENUMBRA_KERNEL
