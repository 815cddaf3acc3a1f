// The kinds of rays, and how many of each were sent; and the samples that went wrong. A kind that is added here is
// counted, saved and reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <tuple>

namespace penumbra {

// `eye`: one for each sample, whatever the lens model needs to aim it.
enum class RayKind : std::uint8_t { eye, shadow, reflection, transmission };

inline constexpr std::string_view ray_kind_names[] = {"camera", "shadow", "reflection", "transmission"};
inline constexpr std::size_t ray_kind_count = std::size(ray_kind_names);

// Samples whose colour is infinite or not a number, and the first of them by row, column and number.
struct NotFiniteSamples {
  std::uint64_t count = 0;
  std::uint32_t x = 0, y = 0, sample = 0;

  NotFiniteSamples& operator+=(const NotFiniteSamples& other) {
    if (other.count > 0 && (count == 0 || std::tie(other.y, other.x, other.sample) < std::tie(y, x, sample))) {
      x = other.x, y = other.y, sample = other.sample;
    }
    count += other.count;
    return *this;
  }
};

struct RayCounts {
  std::array<std::uint64_t, ray_kind_count> counts{};  // in the order of RayKind
  NotFiniteSamples not_finite;

  std::uint64_t& operator[](RayKind kind) { return counts[static_cast<std::size_t>(kind)]; }
  std::uint64_t operator[](RayKind kind) const { return counts[static_cast<std::size_t>(kind)]; }

  RayCounts& operator+=(const RayCounts& other) {
    for (std::size_t kind = 0; kind < ray_kind_count; kind++) counts[kind] += other.counts[kind];
    not_finite += other.not_finite;
    return *this;
  }
  std::uint64_t total() const { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); }
};

}  // namespace penumbra
