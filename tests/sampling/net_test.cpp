// What Sobol points promise exactly: at every power of two, each elementary interval of the first two joint dimensions
// and of every padded pair holds one point ((0,2)-nets); joint dimensions that shape pictures together are nets of a
// certain quality; each dimension is stratified; later aligned blocks are nets too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sampling/points.hpp"

namespace penumbra::test {
namespace {

// Whether the first 2^m points have one in each of the 2^a by 2^(m-a) intervals.
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

// Later blocks are nets too: one picture after another with 64 samples each.
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

// The least t such that the first 2^m points have 2^t in each elementary interval of volume 2^(t-m).
class NetQuality {
 public:
  NetQuality(const std::vector<std::vector<float>>& coordinates, int m) : coordinates_(coordinates), m_(m) {}

  int t() const {
    for (int bits = m_; bits > 0; bits--) {
      if (all_shapes_hold(std::vector<std::size_t>(std::size_t{1} << m_), 0, bits, bits)) return m_ - bits;
    }
    return m_;
  }

 private:
  // For all ways to distribute the `left` bits over the dimensions from `dimension` on; `cells` locates the points by
  // the bits of the earlier dimensions.
  bool all_shapes_hold(const std::vector<std::size_t>& cells, std::size_t dimension, int left, int bits) const {
    if (dimension == coordinates_.size()) {
      std::vector<int> counts(std::size_t{1} << bits);
      for (const std::size_t cell : cells) counts[cell]++;
      return left > 0 || std::ranges::all_of(counts, [&](int count) { return count == 1 << (m_ - bits); });
    }
    for (int here = 0; here <= left; here++) {
      std::vector<std::size_t> finer(cells.size());
      for (std::size_t i = 0; i < cells.size(); i++) {
        const float place = coordinates_[dimension][i] * static_cast<float>(1 << here);
        finer[i] = (cells[i] << here) + static_cast<std::size_t>(place);
      }
      if (!all_shapes_hold(finer, dimension + 1, left - here, bits)) return false;
    }
    return true;
  }

  const std::vector<std::vector<float>>& coordinates_;
  int m_;
};

// For 4, 8, ... 512 points, as bench/direction_numbers.cpp prints for the numbers it finds.
TEST(Sobol, JointDimensionsAreNetsTogether) {
  const Frame frame = sampling_frame(Pattern::sobol, 512, 5);
  std::vector<std::vector<float>> all;
  for (const Dimensions pair : {Dimensions{pixel_x}, Dimensions{lens_radius}, Dimensions{first_light_radius}}) {
    const Points points = points_of(frame, 7, 4, pair, 512);
    all.push_back(points.u);
    all.push_back(points.v);
  }
  all.push_back(points_of(frame, 7, 4, time_dimension, 512).u);
  struct Promise {
    const char* name;
    std::vector<JointDimension> dimensions;
    std::array<int, 8> t;
  };
  const Promise promises[] = {
      {"lens", {lens_radius, lens_angle}, {0, 0, 1, 0, 1, 1, 1, 2}},
      {"light", {first_light_radius, first_light_angle}, {0, 0, 1, 1, 1, 1, 2, 2}},
      {"pixel and time", {pixel_x, pixel_y, shutter_time}, {1, 1, 2, 2, 1, 2, 2, 2}},
      {"pixel and lens", {pixel_x, pixel_y, lens_radius, lens_angle}, {1, 1, 2, 2, 3, 4, 3, 3}},
      {"pixel and light", {pixel_x, pixel_y, first_light_radius, first_light_angle}, {1, 2, 1, 2, 2, 2, 3, 3}},
  };
  for (const Promise& promise : promises) {
    std::vector<std::vector<float>> coordinates;
    for (const JointDimension d : promise.dimensions) coordinates.push_back(all[d]);
    for (int m = 2; m <= 9; m++) {
      EXPECT_EQ(NetQuality(coordinates, m).t(), promise.t[static_cast<std::size_t>(m - 2)]) << promise.name << " " << m;
    }
  }
}

// Defects that the check notices.
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
  // Two dimensions with different shuffles are no net together.
  other.u = points_of(frame, 3, 2, {0x00012345u}, 64).u;
  other.v = points_of(frame, 3, 2, {0x2c1b3c6du}, 64).v;
  EXPECT_TRUE(is_net(other, 6, 6) && is_net(other, 6, 0));
  EXPECT_FALSE(is_net_throughout(other));
}

}  // namespace
}  // namespace penumbra::test
