// What a film holds, and what it frees.
#include "rendering/film.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rendering/film_values.hpp"

namespace penumbra::test {
namespace {

std::size_t bytes_of_address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(Film, ForgettingALayerFreesItsMemory) {
  Film film({0, 0, 4000, 1000}, all_layers);
  const std::size_t pixels = 4000 * 1000;
  for (const LayerRow& row : layer_table) {
    if (row.layer == Layer::color) continue;
    const std::size_t before = bytes_of_address_space();
    film.forget(row.layer);
    EXPECT_GE(before - bytes_of_address_space(), row.sums() * sizeof(double) * pixels) << row.name;
  }
  EXPECT_EQ(film.color().size(), 3 * pixels);
}

}  // namespace
}  // namespace penumbra::test
