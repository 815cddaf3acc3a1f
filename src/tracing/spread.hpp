// Mirror and refraction directions, and how they are spread: a random vector of a ball is added to the unit direction,
// and what then points to the wrong side of the surface is folded back.
#pragma once

#include "sampling/sampler.hpp"
#include "sampling/warp.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// d - 2 (d.n) n
PENUMBRA_INLINE Float3 reflect(Float3 d, Float3 n) { return d - n * (Floats(2) * dot(d, n)); }

// Turns back over the surface what points below it.
PENUMBRA_INLINE Float3 fold(Float3 direction, Float3 side) {
  return direction - side * (Floats(2) * min(dot(direction, side), Floats(0)));
}

struct Refraction {
  Float3 direction;  // unit; not a number where the reflection is total
  Mask total;
};

// Snell's law for the unit direction d, the normal n on its side of the surface, and the ratio of the refraction index
// on this side to that on the other.
PENUMBRA_INLINE Refraction refract(Float3 d, Float3 n, Floats index_ratio) {
  const Floats cosine = -dot(d, n);
  const Floats k = Floats(1) - index_ratio * index_ratio * (Floats(1) - cosine * cosine);
  const Float3 direction = d * index_ratio + n * (index_ratio * cosine - sqrt(max(k, Floats(0))));
  return {normalize(direction), k < Floats(0)};
}

// Spreads unit directions inside a ball of `radius`; the result stays on the side of the surface that `side` points to.
template <typename AnySampler, typename Word>
PENUMBRA_INLINE Float3 spread(Float3 direction, Floats radius, Float3 side, const AnySampler& sampler, Word dimension) {
  const Float3 ball = warp_to_ball(sampler.pair(dimension), sampler.single(dimension + Word(1)));
  // A right-handed frame round the direction (Duff et al. 2017): the ball's z runs along it.
  const Floats sign = copysign(Floats(1), direction.z);
  const Floats a = Floats(-1) / (sign + direction.z);
  const Floats b = direction.x * direction.y * a;
  const Float3 u{Floats(1) + sign * direction.x * direction.x * a, sign * b, -(sign * direction.x)};
  const Float3 v{b, sign + direction.y * direction.y * a, -direction.y};
  const Float3 moved = direction + (u * ball.x + v * ball.y + direction * ball.z) * radius;
  const Float3 folded = fold(moved, side);
  const Floats length2 = dot(folded, folded);
  const Mask usable = (radius > Floats(0)) & (length2 > Floats(1e-30f));
  return select(usable, folded * (Floats(1) / sqrt(length2)), direction);
}

}  // namespace penumbra::PENUMBRA_KERNEL
