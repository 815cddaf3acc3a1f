// What a film holds, and what it lets go of.
#include "rendering/film.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

namespace penumbra {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool counts_memory = false;
#else
constexpr bool counts_memory = true;
#endif

// Large blocks, which go back to the system as soon as they are freed.
std::size_t bytes_in_large_blocks() { return ::mallinfo2().hblkhd; }

TEST(Film, ForgettingALayerFreesItsMemory) {
  if (!counts_memory) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  Film film({0, 0, 4000, 1000}, {true, true, true, true, true});
  const std::size_t pixels = 4000 * 1000;
  const auto freed_by = [](auto forget) {
    const std::size_t before = bytes_in_large_blocks();
    forget();
    return before - bytes_in_large_blocks();
  };
  EXPECT_GE(freed_by([&] { film.forget_depth(); }), 2 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_normal(); }), 3 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_albedo(); }), 3 * sizeof(double) * pixels);
  EXPECT_GE(freed_by([&] { film.forget_variance(); }), 3 * sizeof(double) * pixels);
  EXPECT_EQ(film.color().size(), 3 * pixels);
}

}  // namespace
}  // namespace penumbra
