// What the builder of the hierarchy sorts: the bounds of a leaf, in single precision, and what testing it costs.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

namespace penumbra {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max(Float4 a, Float4 b) { return a > b ? a : b; }

// Bounds whose three axes are computed at once; the fourth lane has no meaning.
struct FloatBounds {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Float4 lo{infinity, infinity, infinity, infinity};
  Float4 hi{-infinity, -infinity, -infinity, -infinity};

  void include(const FloatBounds& b) {
    lo = min(lo, b.lo);
    hi = max(hi, b.hi);
  }
  void include(Float4 point) { include({point, point}); }
};

struct alignas(16) BvhItem {
  float lo[3];         // bounds, rounded outward
  std::uint32_t leaf;  // index of the item for the caller
  float hi[3];
  std::uint32_t cost;  // of testing it, in tests of a sphere

  FloatBounds bounds() const {
    constexpr Int4 axes{-1, -1, -1, 0};
    Int4 low, high;
    std::memcpy(&low, lo, sizeof low);
    std::memcpy(&high, hi, sizeof high);
    return {reinterpret_cast<Float4>(low & axes), reinterpret_cast<Float4>(high & axes)};
  }
};

inline int longest_axis(Float4 extent) {
  return extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
}

// The centre, doubled.
inline Float4 center_of(const FloatBounds& b) { return b.lo + b.hi; }

}  // namespace penumbra
