// Solid stone: irregular stones of one colour each, set in grey mortar of even width. The stones are the cells of
// cellular noise; noise of small contrast lies over both, fine on the mortar and broad on the stones.
#pragma once

#include "tracing/cells.hpp"
#include "tracing/noise.hpp"

namespace penumbra::PENUMBRA_KERNEL {

inline constexpr float cubes_per_unit = 3.1f;
inline constexpr float mortar_half_width = 0.0115f * cubes_per_unit;  // in cubes

struct StoneCell {
  Floats border;  // distance to the border in cubes, or half the mortar's width if that is less
  Ints bits;      // random, one word for each stone
};

inline StoneCell stone_cell(Float3 p, Mask lanes) {
  const Float3 place = p * Floats(cubes_per_unit);
  const NearestFeature own = nearest_feature(place, lanes);
  return {border_distance(place, lanes, own, mortar_half_width), mix_bits(own.bits)};
}

// Ten bits as a number from 0 to 1.
PENUMBRA_INLINE Floats stone_share(Ints bits) { return to_floats(bits & Ints(1023)) * Floats(1.0f / 1023); }

// Orange to red; one in seventeen paler, one in twenty-five brown.
inline Float3 stone_tint(Ints bits) {
  const Floats kind = stone_share(bits >> 20);
  const Floats red =
      select(kind < Floats(0.04f), Floats(0.61f), select(kind < Floats(0.1f), Floats(0.76f), Floats(0.82f)));
  return {red, Floats(0.30f) + Floats(0.10f) * stone_share(bits),
          Floats(0.06f) + Floats(0.21f) * stone_share(bits >> 10)};
}

inline Float3 stone_color(Float3 p, Mask lanes) {
  const StoneCell cell = stone_cell(p, lanes);
  const Mask mortar = cell.border < Floats(mortar_half_width);
  const Floats scale = select(mortar, Floats(60), Floats(10));
  const Floats contrast = select(mortar, Floats(0.1f), Floats(0.05f));
  const Floats noise = contrast * noise3({p.x * scale, p.y * scale, p.z * scale});
  const Floats grey = Floats(0.6f);
  const Float3 color = select(mortar, Float3{grey, grey, grey}, stone_tint(cell.bits));
  return {color.x + noise, color.y + noise, color.z + noise};
}

}  // namespace penumbra::PENUMBRA_KERNEL
