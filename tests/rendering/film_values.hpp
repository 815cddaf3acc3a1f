// All numbers of a film, to compare films to the bit.
#pragma once

#include <array>

#include "rendering/film.hpp"

namespace penumbra::test {

inline constexpr Layers all_layers = [] {
  Layers layers;
  for (const LayerRow& row : layer_table) layers.add(row.layer);
  return layers;
}();

using FilmValues = std::array<ZeroedVector<float>, layer_count>;

inline FilmValues values_of(const Film& film) {
  FilmValues values;
  for (const LayerRow& row : layer_table) {
    if (film.layers().has(row.layer) || row.layer == Layer::samples)
      values[index_of(row.layer)] = film.layer(row.layer);
  }
  return values;
}

}  // namespace penumbra::test
