// Triangles are told apart by a hash of their corners. Sorting the hashes of millions would take long; so each first
// sets one bit of a table, and only those that found theirs set, or have it in common with such a one, are sorted.
#include "geometry/coincident_triangles.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace penumbra {
namespace {

// A bijection of 64-bit words ("splitmix64", Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t hash_of_corner(const float* p) {
  const auto word = [&](int axis) { return std::uint64_t{std::bit_cast<std::uint32_t>(p[axis] + 0.0f)}; };  // -0 is 0
  return mix(mix(word(0) | (word(1) << 32)) + word(2));
}

// Calls visit(hash) for each triangle.
template <class Visit>
void for_hashes(const TriangleStore& store, std::span<const TriangleRange> ranges, const Visit& visit) {
  for (const TriangleRange& range : ranges) {
    const std::uint32_t* corner = store.indices.data() + std::size_t{3} * range.first;
    for (std::uint32_t i = 0; i < range.count; i++, corner += 3) {
      std::uint64_t hash = 0;  // a sum, for which the order of the corners is all one
      for (int k = 0; k < 3; k++) hash += hash_of_corner(&store.vertices[std::size_t{3} * corner[k]]);
      visit(hash);
    }
  }
}

// As many bits as a table of eight a triangle has, at the least.
class Bits {
 public:
  explicit Bits(std::uint64_t triangles) : words_(std::bit_ceil(triangles / 8 + 1)) {}
  bool has(std::uint64_t hash) const { return (word(hash) >> (hash & 63) & 1) != 0; }
  void set(std::uint64_t hash) { words_[hash >> 6 & (words_.size() - 1)] |= std::uint64_t{1} << (hash & 63); }

 private:
  std::uint64_t word(std::uint64_t hash) const { return words_[hash >> 6 & (words_.size() - 1)]; }
  std::vector<std::uint64_t> words_;
};

}  // namespace

bool any_coincide(const TriangleStore& store, std::span<const TriangleRange> ranges) {
  std::uint64_t count = 0;
  for (const TriangleRange& range : ranges) count += range.count;
  Bits seen(count), again(count);
  for_hashes(store, ranges, [&](std::uint64_t hash) { (seen.has(hash) ? again : seen).set(hash); });
  std::vector<std::uint64_t> suspects;
  for_hashes(store, ranges, [&](std::uint64_t hash) {
    if (again.has(hash)) suspects.push_back(hash);
  });
  std::sort(suspects.begin(), suspects.end());
  return std::adjacent_find(suspects.begin(), suspects.end()) != suspects.end();
}

}  // namespace penumbra
