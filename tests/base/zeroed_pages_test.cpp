// Large arrays begin as zeros, even where memory was used before, and are vectors in all other ways.
#include "base/zeroed_pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace penumbra {
namespace {

TEST(ZeroedPages, BeginAsZeros) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, (std::size_t{1} << 18) - 1, std::size_t{1} << 18,
                                 (std::size_t{1} << 18) + 1, std::size_t{4} << 20, std::size_t{5'000'003}}) {
    for (int turn = 0; turn < 3; turn++) {
      ZeroedVector<std::uint8_t> bytes(size);
      EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 0), static_cast<std::ptrdiff_t>(size));
      std::fill(bytes.begin(), bytes.end(), std::uint8_t{255});
    }
  }
}

TEST(ZeroedPages, AreCopiedAndMoved) {
  ZeroedVector<double> numbers(300'000);
  numbers[7] = 7;
  numbers.back() = 8;
  const ZeroedVector<double> copy = numbers;
  const double* const place = numbers.data();
  const ZeroedVector<double> moved = std::move(numbers);
  EXPECT_EQ(moved.data(), place);
  EXPECT_TRUE(copy == moved);
  EXPECT_EQ(copy[7] + copy.back(), 15);
}

TEST(ZeroedPages, KeepTheAlignmentOfTheirType) {
  struct alignas(64) Line {
    char bytes[64];
  };
  for (const std::size_t size : {std::size_t{1}, std::size_t{3}, std::size_t{100}, std::size_t{100'000}}) {
    const ZeroedVector<Line> lines(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lines.data()) % 64, 0u) << size << " lines";
  }
}

TEST(ZeroedPages, TooManyAreRefused) {
  EXPECT_THROW(ZeroedPages<double>().allocate(std::size_t{1} << 60), std::bad_alloc);
  EXPECT_THROW(ZeroedPages<double>().allocate(std::size_t{1} << 57), std::bad_alloc);
}

}  // namespace
}  // namespace penumbra
