// Random permutations: every index occurs once, at every length; all orders are equally likely where they can be
// counted, and all triples of places for longer lists. One seed in a million fails.
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "base/test_scale.hpp"
#include "probes/lane_probes.hpp"
#include "rendering/isa.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

std::vector<std::uint32_t> permuted(std::vector<std::uint32_t> index, std::uint32_t length,
                                    const std::vector<std::uint32_t>& key) {
  probes_of(*usable_kernels().back()).permute(index, length, key);
  return index;
}

std::vector<std::uint32_t> whole(std::uint32_t length, std::uint32_t key) {
  std::vector<std::uint32_t> index(length);
  std::iota(index.begin(), index.end(), 0u);
  return permuted(index, length, std::vector<std::uint32_t>(length, key));
}

// Where `index` goes under the keys first, first + 1, ...
std::vector<std::uint32_t> by_key(std::uint32_t index, std::uint32_t length, std::size_t keys, std::uint32_t first) {
  std::vector<std::uint32_t> key(keys);
  std::iota(key.begin(), key.end(), first);
  return permuted(std::vector<std::uint32_t>(keys, index), length, key);
}

TEST(Permutations, MeetEveryIndexOnce) {
  std::vector<std::uint32_t> lengths(70);
  std::iota(lengths.begin(), lengths.end(), 1u);
  for (const std::uint32_t length : {100u, 255u, 256u, 257u, 1000u, 1023u, 1024u, 1025u, 4097u, 65537u}) {
    lengths.push_back(length);
  }
  if (!slow_build) lengths.push_back((1u << 20) + 1);
  for (const std::uint32_t length : lengths) {
    for (const std::uint32_t key : {0u, 1u, 0x9e3779b9u}) {
      std::vector<char> met(length);
      for (const std::uint32_t place : whole(length, key)) {
        ASSERT_LT(place, length);
        ASSERT_FALSE(met[place]) << length;
        met[place] = 1;
      }
    }
  }
}

TEST(Permutations, ReachTheLargestLength) {
  const std::uint32_t length = (1u << 26) - 5;
  std::vector<std::uint32_t> index(1024);
  std::iota(index.begin(), index.end(), length - 1024);
  for (const std::uint32_t place : permuted(index, length, std::vector<std::uint32_t>(1024, 7))) {
    EXPECT_LT(place, length);
  }
}

TEST(Permutations, AllOrdersAreEquallyLikely) {
  const double limit = normal_limit(6);
  for (std::uint32_t length = 2; length <= 7; length++) {
    std::uint32_t orders = 1;
    for (std::uint32_t i = 2; i <= length; i++) orders *= i;
    const std::size_t keys = scaled(400000, 60000);
    std::vector<std::vector<std::uint32_t>> places;
    for (std::uint32_t i = 0; i < length; i++) places.push_back(by_key(i, length, keys, length << 24));
    std::vector<int> counts(orders);
    for (std::size_t key = 0; key < keys; key++) {
      std::uint32_t order = 0;  // its number in the factorial number system
      for (std::uint32_t i = 0; i < length; i++) {
        std::uint32_t smaller = 0;
        for (std::uint32_t k = i + 1; k < length; k++) smaller += places[k][key] < places[i][key] ? 1 : 0;
        order = order * (length - i) + smaller;
      }
      counts[order]++;
    }
    EXPECT_LT(chi_square_deviation(counts), limit) << length;
  }
}

// Counts where the three indices go, for each triple of places.
std::vector<int> triples(std::uint32_t length, const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                         const std::vector<std::uint32_t>& c) {
  std::vector<int> all(std::size_t{length} * length * length);
  for (std::size_t i = 0; i < a.size(); i++) all[(a[i] * length + b[i]) * length + c[i]]++;
  std::vector<int> counts;
  for (std::uint32_t x = 0; x < length; x++) {
    for (std::uint32_t y = 0; y < length; y++) {
      for (std::uint32_t z = 0; z < length; z++) {
        if (x != y && y != z && x != z) counts.push_back(all[(x * length + y) * length + z]);
      }
    }
  }
  return counts;
}

TEST(Permutations, AllTriplesAreEquallyLikely) {
  const std::uint32_t lengths[] = {8, 16, 17, 24, 32, 33, 40};
  const double limit = normal_limit(3 * std::size(lengths));
  const std::size_t keys = scaled(300000, 100000);
  for (const std::uint32_t n : lengths) {
    for (const auto& [a, b, c] : {std::array{0u, 1u, 2u}, {0u, n / 2, n - 1}, {n - 3, n - 2, n - 1}}) {
      const std::vector<int> counts = triples(n, by_key(a, n, keys, 0), by_key(b, n, keys, 0), by_key(c, n, keys, 0));
      if (keys < 5 * counts.size()) continue;
      EXPECT_LT(chi_square_deviation(counts), limit) << n << ": " << a << " " << b << " " << c;
    }
  }
  // Rotating a list by a random number of places makes single places uniform, but not triples.
  std::vector<std::uint32_t> a, b, c;
  for (const std::uint32_t turn : by_key(0, 16, keys, 0)) {
    a.push_back(turn);
    b.push_back((turn + 1) % 16);
    c.push_back((turn + 2) % 16);
  }
  EXPECT_GT(chi_square_deviation(triples(16, a, b, c)), limit);
}

// Long lists, in 4 or 25 classes of places: neighbours, and indices half a list apart, land independently.
TEST(Permutations, PairsOfLongOnesAreIndependent) {
  const std::uint32_t lengths[] = {100, 128, 1000, 1024, 5000, 65536, 1000003};
  const double limit = normal_limit(2 * std::size(lengths));
  const std::size_t keys = scaled(200000, 30000);
  for (const std::uint32_t n : lengths) {
    const std::uint32_t classes = n < 1000 ? 4 : 25;
    for (const auto& [a, b] : {std::pair(0u, 1u), {1u, n / 2 + 1}}) {
      const std::vector<std::uint32_t> first = by_key(a, n, keys, 5), second = by_key(b, n, keys, 5);
      std::vector<int> counts(std::size_t{classes} * classes);
      std::vector<double> expected(counts.size());
      std::vector<std::uint32_t> sizes(classes);
      for (std::uint32_t i = 0; i < n; i++) sizes[std::uint64_t{i} * classes / n]++;
      for (std::size_t i = 0; i < keys; i++) {
        counts[std::uint64_t{first[i]} * classes / n * classes + std::uint64_t{second[i]} * classes / n]++;
      }
      // Classes differ in size by at most one, and two indices never share a place.
      double chi_square = 0;
      for (std::uint32_t x = 0; x < classes; x++) {
        for (std::uint32_t y = 0; y < classes; y++) {
          const double pairs = double{static_cast<double>(sizes[x])} * (sizes[y] - (x == y ? 1.0 : 0.0));
          const double e = static_cast<double>(keys) * pairs / (static_cast<double>(n) * (n - 1.0));
          const double difference = counts[std::size_t{x} * classes + y] - e;
          chi_square += difference * difference / e;
        }
      }
      const double freedom = classes * classes - 1.0;
      const double deviation =
          (std::cbrt(chi_square / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
      EXPECT_LT(deviation, limit) << n;
    }
  }
}

}  // namespace
}  // namespace penumbra::test
