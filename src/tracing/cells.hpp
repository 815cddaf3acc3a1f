// Cellular noise (Worley, "A Cellular Texture Basis Function", 1996): space is cut into unit cubes with one feature
// point each, and every place belongs to the nearest point. The distance to the border is that to the plane half way
// between the two points concerned (Quilez, "Voronoi borders", 2012) and not the difference of the two distances, so
// that a border of constant distance is a slab of even width.
//
// No neighbourhood is taken on trust: the search goes to every cube that can hold a point near enough to matter. The
// nearest point is at most sqrt(3) away, as the own cube has one, so that two cubes to each side are enough.
#pragma once

#include "base/hash.hpp"
#include "base/lane_math.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// One coordinate of the cubes round a point: `step` of them are between theirs and its own.
struct CubeAxis {
  Ints cube;        // its own
  Floats fraction;  // of the point in it
  int side;         // of the nearer neighbour, in the first lane that counts: 1 or -1

  PENUMBRA_INLINE CubeAxis(Floats x, Mask lanes) {
    const Floats below = floor(x);
    cube = truncate(below);
    fraction = x - below;
    const std::uint32_t left = bits(lanes & (fraction < Floats(0.5f)));
    side = (left & bits(lanes) & (0u - bits(lanes))) != 0 ? -1 : 1;
  }

  PENUMBRA_INLINE Floats distance(int step) const {
    if (step == 0) return Floats(0);
    return step > 0 ? Floats(static_cast<float>(step)) - fraction : fraction - Floats(static_cast<float>(step + 1));
  }

  // From the point to the feature point, whose place in its cube is the middle of one of 1024 equal parts.
  PENUMBRA_INLINE Floats way(int step, Ints ten_bits) const {
    const Floats first = Floats(static_cast<float>(step) + 0.5f / 1024) - fraction;
    return to_floats(ten_bits & Ints(1023)) * Floats(1.0f / 1024) + first;
  }
};

PENUMBRA_INLINE Ints hash_step(Ints before, Ints cube, int step) {
  return mix_bits((cube + Ints(static_cast<std::uint32_t>(step))) * Ints(0x9e3779b9u) + before);
}

// Calls visit(way, square, bits) for the feature points of all cubes that any of the lanes has less than the square
// root of `reach` away, from near to far: the way from p to the point, its length squared, and the bits that chose the
// point. `reach` may shrink on the way. More points than a lane needs, and the order of them, depend on the other
// lanes.
template <typename Visit>
PENUMBRA_INLINE void visit_feature_points(Float3 p, Mask lanes, const Floats& reach, Visit visit) {
  constexpr int steps[] = {0, 1, -1, 2, -2};
  const CubeAxis x(p.x, lanes), y(p.y, lanes), z(p.z, lanes);
  for (const int step_x : steps) {
    const int i = step_x * x.side;
    const Floats dx = x.distance(i);
    const Floats square_x = dx * dx;
    if (none(lanes & (square_x < reach))) continue;
    const Ints hash_x = hash_step(Ints(0u), x.cube, i);
    for (const int step_y : steps) {
      const int j = step_y * y.side;
      const Floats dy = y.distance(j);
      const Floats square_xy = square_x + dy * dy;
      if (none(lanes & (square_xy < reach))) continue;
      const Ints hash_xy = hash_step(hash_x, y.cube, j);
      for (const int step_z : steps) {
        const int k = step_z * z.side;
        const Floats dz = z.distance(k);
        if (none(lanes & (square_xy + dz * dz < reach))) continue;
        const Ints bits = hash_step(hash_xy, z.cube, k);
        const Float3 way{x.way(i, bits), y.way(j, bits >> 10), z.way(k, bits >> 20)};
        visit(way, dot(way, way), bits);
      }
    }
  }
}

struct NearestFeature {
  Float3 way;     // from the place to the point
  Floats square;  // of the distance
  Ints bits;      // that chose the point: name of the cell
};

// Of two points at the same distance it is either one, whichever came first: such a place is on a border, and borders
// have no owner.
inline NearestFeature nearest_feature(Float3 p, Mask lanes) {
  NearestFeature nearest;
  nearest.way = {Floats(0), Floats(0), Floats(0)};
  nearest.square = Floats(4);  // more than it ever is
  nearest.bits = Ints(0u);
  visit_feature_points(p, lanes, nearest.square, [&](Float3 way, Floats square, Ints bits) {
    const Mask nearer = square < nearest.square;
    nearest.way = select(nearer, way, nearest.way);
    nearest.square = select(nearer, square, nearest.square);
    nearest.bits = select(nearer, bits, nearest.bits);
  });
  return nearest;
}

// The distance from p to the nearest border of its cell, or `farthest` (at most 1/8) where that is less. A point whose
// border is nearer than this is nearer itself than the cell's own point plus twice this.
inline Floats border_distance(Float3 p, Mask lanes, const NearestFeature& own, float farthest) {
  const Floats radius = sqrt(own.square) + Floats(2 * farthest);
  const Floats reach = radius * radius;
  Floats nearest = Floats(farthest);
  visit_feature_points(p, lanes, reach, [&](Float3 way, Floats square, Ints) {
    const Float3 across = way - own.way;
    const Floats width = dot(across, across);  // 0 for the own point, exactly
    const Floats border = (square - own.square) / (Floats(2) * sqrt(width));
    nearest = select(width > Floats(0), min(border, nearest), nearest);
  });
  return nearest;
}

}  // namespace penumbra::PENUMBRA_KERNEL
