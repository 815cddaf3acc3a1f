// What a film holds, and what it frees.
#include "rendering/film.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "rendering/film_values.hpp"

namespace penumbra::test {
namespace {

// In bytes.
struct Memory {
  std::size_t address_space = 0, resident = 0;
};

Memory memory_of_process() {
  Memory memory;
  std::ifstream("/proc/self/statm") >> memory.address_space >> memory.resident;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return {memory.address_space * page, memory.resident * page};
}

// Larger than what is taken at once, and not a multiple of it.
constexpr PixelRect crop{0, 0, 1500, 1001};

Film full_film() {
  Film film(crop, all_layers);
  double value = 0;
  const FilmView view = film.view();
  for (const FilmPlane& plane : view.all()) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(plane.sums_per_pixel) * crop.pixel_count(); i++) {
      plane.sums[i] = (value += 0.25);
    }
  }
  std::vector<Pixel> pixels;
  for_pixels(crop, [&](int x, int y) {
    pixels.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
  });
  film.set_samples(pixels, 4);
  film.set_samples(std::span(pixels).first(2000), 3);
  return film;
}

TEST(Film, TakingALayerGivesItsValuesAndFreesItsMemory) {
  Film film = full_film();
  for (const Layer layer :
       {Layer::depth, Layer::normal, Layer::albedo, Layer::variance, Layer::samples, Layer::color}) {
    const LayerRow& row = row_of(layer);
    const ZeroedVector<float> expected = film.layer(layer);
    const Memory before = memory_of_process();
    const ZeroedVector<float> taken = film.take(layer);
    const Memory after = memory_of_process();
    EXPECT_TRUE(taken == expected) << row.name;
    if (row.sums() == 0) continue;
    const std::size_t freed = row.sums() * sizeof(double) * crop.pixel_count();
    const std::size_t needed = row.channels.size() * sizeof(float) * crop.pixel_count();
    const std::size_t page = std::size_t{2} << 20;
    EXPECT_GE(before.address_space + needed + page, after.address_space + freed) << row.name;
    EXPECT_LE(after.resident, before.resident) << row.name;
  }
}

}  // namespace
}  // namespace penumbra::test
