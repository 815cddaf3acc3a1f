// What a film holds, and what it lets go of.
#include "rendering/film.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace penumbra {
namespace {

std::size_t bytes_of_address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(Film, ForgettingALayerFreesItsMemory) {
  Film film({0, 0, 4000, 1000}, {true, true, true, true, true});
  const std::size_t pixels = 4000 * 1000;
  const auto freed_by = [](auto forget) {
    const std::size_t before = bytes_of_address_space();
    forget();
    return before - bytes_of_address_space();
  };
  EXPECT_GE(freed_by([&] { film.forget_depth(); }), 2 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_normal(); }), 3 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_albedo(); }), 3 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_variance(); }), 3 * sizeof(double) * pixels);
  EXPECT_EQ(film.color().size(), 3 * pixels);
}

}  // namespace
}  // namespace penumbra
