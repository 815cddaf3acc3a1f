// `multijittered`: one point in each of `count` cells, as jittered ones, and also one in each of `count` columns and
// `count` rows (Chiu, Shirley, Wang 1994); all rows of cells share one order within their columns and all columns one
// within their rows, which keeps neighbours apart (Kensler, "Correlated multi-jittered sampling", 2013).
//
// Columns and rows hold one point each for any count; the cells do where count = rows * columns (strata.hpp). Where
// some rows are longer, the columns are numbered through from a random one: no column prefers the long rows.
#pragma once

#include "sampling/jittered.hpp"

namespace penumbra::PENUMBRA_KERNEL {

inline Pair multijittered_pair(Ints key, Ints other_key, Ints index, std::uint32_t count) {
  const Strata strata(count);
  const Stratum stratum = stratum_at(strata, permute(index, count, mix_bits(key ^ Ints(0x3c6ef372u))));
  const Ints row_key = mix_bits(key ^ Ints(0x78dde6e4u)), column_key = mix_bits(other_key ^ Ints(0x1715609du));
  const std::uint32_t short_rows = strata.rows - strata.long_rows;
  Ints row_rank = permute(stratum.row - Ints(strata.long_rows), short_rows, row_key) + Ints(strata.long_rows);
  Ints column_rank = permute(stratum.column, strata.columns, column_key);
  if (strata.long_rows != 0) {
    // Of the points in one column of cells, those of the long rows come first.
    row_rank = select(stratum.in_long_row, permute(stratum.row, strata.long_rows, row_key), row_rank);
    column_rank = select(stratum.in_long_row, permute(stratum.column, strata.columns + 1, column_key), column_rank);
  }
  Ints column = stratum.column * Ints(strata.rows) + row_rank;
  if (strata.long_rows != 0) {
    column += pick(mix_bits(column_key), Ints(count));
    column = select(column < Ints(count), column, column - Ints(count));
  }
  const Pair place = random_pair(key, other_key, index);
  return {place_on_line(count, column, place.u), place_on_line(count, stratum.start + column_rank, place.v)};
}

inline Floats multijittered_single(Ints key, Ints index, std::uint32_t count) {
  return jittered_single(key, index, count);
}

}  // namespace penumbra::PENUMBRA_KERNEL
