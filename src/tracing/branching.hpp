// Which rays of a tree are traced. A surface that reflects and transmits sends two rays, so a tree of depth d has 2^d
// of them, most of which hardly count. Near the eye both are traced, as the lecture has it. Where they are worth
// little, one of the two goes on, chosen with a probability in proportion to what it is worth, and at further hits one
// at most: Russian roulette (Arvo and Kirk, "Particle transport and image synthesis", 1990), which leaves the mean of
// the picture as it is.
#pragma once

#include "tracing/tree.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// A lone ray that is worth less than this goes on only as often as it takes to be worth as much: deep rays, which cost
// as much and of which hardly any sees something new, must be worth more.
PENUMBRA_INLINE Floats worth_of_one(Ints depth) { return Floats(1.0f / 16) + to_floats(depth) * Floats(1.0f / 64); }

// Where one of two rays goes on alone: the geometric mean of what both are worth is too small.
PENUMBRA_INLINE Mask worth_one(Floats weight, Floats reflection, Floats transmission) {
  return abs(reflection * transmission) * weight * weight < Floats(least_worth_of_two * least_worth_of_two);
}

// The rays that go on alone, where hits might send one or two.
struct Chosen {
  Mask goes_on, through;  // at all; the transmitted one
  Floats factor;          // what it is worth
};

PENUMBRA_INLINE Chosen choose_one(Floats weight, Ints depth, Floats random, Mask reflects, Mask transmits,
                                  Floats reflection, Floats transmission) {
  const Floats of_reflected = keep(reflects, abs(reflection));
  const Floats sum = of_reflected + keep(transmits, abs(transmission));
  const Floats survival = min(sum * abs(weight) / worth_of_one(depth), Floats(1));
  const Mask goes_on = (reflects | transmits) & (random < survival);
  const Mask through = goes_on & (random * sum >= of_reflected * survival);
  return {goes_on, through, copysign(sum / survival, select(through, transmission, reflection))};
}

}  // namespace penumbra::PENUMBRA_KERNEL
