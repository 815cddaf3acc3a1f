// The kinds of rays, and how many of each were sent. A kind that is added here is counted, saved and reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string_view>

namespace penumbra {

// `eye`: one for each sample, whatever the lens model needs to aim it.
enum class RayKind : std::uint8_t { eye, shadow, reflection, transmission };

inline constexpr std::string_view ray_kind_names[] = {"camera", "shadow", "reflection", "transmission"};
inline constexpr std::size_t ray_kind_count = std::size(ray_kind_names);

struct RayCounts {
  std::array<std::uint64_t, ray_kind_count> counts{};  // in the order of RayKind

  std::uint64_t& operator[](RayKind kind) { return counts[static_cast<std::size_t>(kind)]; }
  std::uint64_t operator[](RayKind kind) const { return counts[static_cast<std::size_t>(kind)]; }

  RayCounts& operator+=(const RayCounts& other) {
    for (std::size_t kind = 0; kind < ray_kind_count; kind++) counts[kind] += other.counts[kind];
    return *this;
  }
  std::uint64_t total() const { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); }
};

}  // namespace penumbra
