// Divides the unit square into `count` cells of equal area, for any count: about sqrt(count) rows, the first
// `count % rows` of which hold one cell more than the others and are proportionally higher.
#pragma once

#include <cstdint>

#include "sampling/fraction.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Strata {
  std::uint32_t count, rows, columns;  // columns: cells in a short row
  std::uint32_t long_rows;             // rows with one cell more

  PENUMBRA_INLINE explicit Strata(std::uint32_t cells) : count(cells) {
    rows = static_cast<std::uint32_t>(__builtin_sqrt(static_cast<double>(count)));
    if (rows * rows + rows < count) rows++;  // rounds to the nearest
    columns = count / rows;
    long_rows = count % rows;
  }
};

struct Stratum {
  Ints row, column;
  Ints columns;  // cells in its row
  Ints start;    // cells in the rows before it
  Mask in_long_row;
};

PENUMBRA_INLINE Stratum stratum_at(const Strata& strata, Ints number) {
  const Ints in_long_rows(strata.long_rows * (strata.columns + 1));
  Stratum stratum;
  stratum.in_long_row = number < in_long_rows;
  stratum.columns = select(stratum.in_long_row, Ints(strata.columns + 1), Ints(strata.columns));
  const Ints before = select(stratum.in_long_row, Ints(0), in_long_rows);
  const Ints row = divide(number - before, stratum.columns);
  stratum.start = before + row * stratum.columns;
  stratum.column = number - stratum.start;
  stratum.row = row + select(stratum.in_long_row, Ints(0), Ints(strata.long_rows));
  return stratum;
}

// Maps a place (u, v) of [0, 1) x [0, 1) into the stratum.
PENUMBRA_INLINE Pair place_in(const Strata& strata, const Stratum& stratum, Pair place) {
  const Floats columns = to_floats(stratum.columns);
  return {below_one((to_floats(stratum.column) + place.u) / columns),
          below_one((to_floats(stratum.start) + place.v * columns) / Floats(static_cast<float>(strata.count)))};
}

// Maps a place of [0, 1) into stratum `number` of `count` on the line.
PENUMBRA_INLINE Floats place_on_line(std::uint32_t count, Ints number, Floats place) {
  return below_one((to_floats(number) + place) / Floats(static_cast<float>(count)));
}

}  // namespace penumbra::PENUMBRA_KERNEL
