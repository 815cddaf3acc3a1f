// What Sobol points promise exactly: at every power of two, each elementary interval of the first two joint dimensions
// and of every padded pair holds one point ((0,2)-nets), each dimension is stratified, and more points only add to
// fewer.
#include <gtest/gtest.h>

#include <bit>

#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

// Whether the first 2^m points have one in each of the 2^m intervals of 2^a by 2^(m-a).
bool is_net(const Points& points, int m, int a) {
  std::vector<int> counts(std::size_t{1} << m);
  for (std::size_t i = 0; i < counts.size(); i++) {
    const auto column = static_cast<std::size_t>(points.u[i] * static_cast<float>(1 << a));
    const auto row = static_cast<std::size_t>(points.v[i] * static_cast<float>(1 << (m - a)));
    counts[(column << (m - a)) + row]++;
  }
  for (const int count : counts) {
    if (count != 1) return false;
  }
  return true;
}

TEST(Sobol, PairsAreNets) {
  constexpr int largest = 12;
  for (const std::uint32_t seed : {0u, 1u, 0xffffffffu}) {
    const Frame frame = sampling_frame(Pattern::sobol, 1 << largest, seed);
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {17, 4000}}) {
      for (const Dimensions dimensions : all_dimensions) {
        if (dimensions.joint() && dimensions.first != 0) continue;
        const Points points = points_of(frame, x, y, dimensions, 1 << largest);
        for (int m = 0; m <= largest; m++) {
          for (int a = 0; a <= m; a++) {
            EXPECT_TRUE(is_net(points, m, a)) << "dimension " << dimensions.first << ", 2^" << m << " points, " << a;
          }
        }
      }
    }
  }
}

TEST(Sobol, EveryDimensionIsStratified) {
  const Frame frame = sampling_frame(Pattern::sobol, 1024, 3);
  for (const Dimensions dimensions : all_dimensions) {
    const Points points = points_of(frame, 5, 6, dimensions, 1024);
    for (int m = 0; m <= 10; m++) {
      EXPECT_TRUE(is_net(points, m, m)) << dimensions.first;
      EXPECT_TRUE(is_net(points, m, 0)) << dimensions.first;
    }
  }
}

// Later blocks are nets too: picture after picture of 64 samples each.
TEST(Sobol, AlignedBlocksAreNets) {
  const Frame frame = sampling_frame(Pattern::sobol, 1024);
  for (const Dimensions dimensions : {Dimensions{pixel_x}, Dimensions{0x2c1b3c6du}}) {
    const Points points = points_of(frame, 3, 2, dimensions, 1024);
    for (std::ptrdiff_t begin = 0; begin < 1024; begin += 64) {
      const Points block{{points.u.begin() + begin, points.u.begin() + begin + 64},
                         {points.v.begin() + begin, points.v.begin() + begin + 64}};
      for (int a = 0; a <= 6; a++) EXPECT_TRUE(is_net(block, 6, a));
    }
  }
}

// Point k is the same whatever the count of samples, and on every machine.
TEST(SamplePoints, ArePureFunctions) {
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    const Frame large = sampling_frame(pattern, 3000, 9);
    for (const Dimensions dimensions : all_dimensions) {
      const Points all = points_of(large, 40, 50, dimensions, 3000);
      for (const std::uint32_t count : {1u, 7u, 16u, 100u, 1025u}) {
        const Frame frame = sampling_frame(pattern, count, 9);
        for (const Kernel* kernel : usable_kernels()) {
          const Points fewer = points_of(frame, 40, 50, dimensions, count, *kernel);
          EXPECT_TRUE(std::equal(fewer.u.begin(), fewer.u.end(), all.u.begin())) << kernel->isa << " " << count;
          EXPECT_TRUE(std::equal(fewer.v.begin(), fewer.v.end(), all.v.begin())) << kernel->isa << " " << count;
        }
      }
      for (const float u : all.u) EXPECT_TRUE(u >= 0 && u < 1);
      for (const float v : all.v) EXPECT_TRUE(v >= 0 && v < 1);
    }
  }
}

TEST(SamplePoints, DependOnSeedPixelAndDimension) {
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    const Frame frame = sampling_frame(pattern, 64, 1), other = sampling_frame(pattern, 64, 2);
    for (const Dimensions dimensions : all_dimensions) {
      const Points points = points_of(frame, 4, 5, dimensions, 64);
      EXPECT_NE(points.u, points_of(other, 4, 5, dimensions, 64).u);
      EXPECT_NE(points.u, points_of(frame, 5, 4, dimensions, 64).u);
      EXPECT_NE(points.u, points_of(frame, 4, 6, dimensions, 64).u);
      EXPECT_NE(points.u, points.v);
      EXPECT_NE(points.v, points_of(other, 4, 5, dimensions, 64).v);
      EXPECT_NE(points.v, points_of(frame, 5, 4, dimensions, 64).v);
    }
  }
}

}  // namespace
}  // namespace penumbra::test
