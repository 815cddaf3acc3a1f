// What Sobol points promise exactly: at every power of two, each elementary interval of the first two joint dimensions
// and of every padded pair holds one point ((0,2)-nets), each dimension is stratified, and more points only add to
// fewer.
#include <gtest/gtest.h>

#include <cmath>

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

// What the check would notice.
bool is_net_throughout(const Points& points) {
  for (int a = 0; a <= 6; a++) {
    if (!is_net(points, 6, a)) return false;
  }
  return true;
}

TEST(NetCheck, NoticesWhatIsNoNet) {
  const Frame frame = sampling_frame(Pattern::sobol, 64, 1);
  const Points net = points_of(frame, 3, 2, {pixel_x}, 64);
  EXPECT_TRUE(is_net_throughout(net));
  // The right numbers, but two of them swapped.
  Points other = net;
  std::swap(other.u[0], other.u[1]);
  EXPECT_TRUE(is_net(other, 6, 6) && is_net(other, 6, 0));
  EXPECT_FALSE(is_net_throughout(other));
  other = net;
  for (float& u : other.u) u = u < 0.99f ? u + 0.01f : u - 0.99f;
  EXPECT_FALSE(is_net(other, 6, 6));
  other = net;
  for (float& u : other.u) u = std::floor(u * 32) / 32;
  EXPECT_FALSE(is_net(other, 6, 6));
  other = net;
  other.u[5] = other.u[6];
  EXPECT_FALSE(is_net(other, 6, 6));
  // Two dimensions of unlike shuffles are no net together.
  other.u = points_of(frame, 3, 2, {0x00012345u}, 64).u;
  other.v = points_of(frame, 3, 2, {0x2c1b3c6du}, 64).v;
  EXPECT_TRUE(is_net(other, 6, 6) && is_net(other, 6, 0));
  EXPECT_FALSE(is_net_throughout(other));
}

}  // namespace
}  // namespace penumbra::test
