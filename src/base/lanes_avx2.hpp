// The operations of lanes.hpp that need intrinsics, for AVX2: 8 lanes, masks as vectors of all ones or zeros.
#pragma once

namespace penumbra::PENUMBRA_KERNEL {

struct Mask {
  UintVector m;

  PENUMBRA_INLINE Mask() = default;
  PENUMBRA_INLINE explicit Mask(UintVector mask) : m(mask) {}
  PENUMBRA_INLINE explicit Mask(bool all) : m((all ? 0xffffffffu : 0u) - UintVector{}) {}
};

PENUMBRA_INLINE __m256i raw(Ints a) { return reinterpret_cast<__m256i>(a.v); }
PENUMBRA_INLINE Ints ints(__m256i a) { return Ints(reinterpret_cast<UintVector>(a)); }
PENUMBRA_INLINE __m256 raw(Mask a) { return reinterpret_cast<__m256>(a.m); }

PENUMBRA_INLINE Mask operator&(Mask a, Mask b) { return Mask(a.m & b.m); }
PENUMBRA_INLINE Mask operator|(Mask a, Mask b) { return Mask(a.m | b.m); }
PENUMBRA_INLINE Mask operator~(Mask a) { return Mask(~a.m); }
PENUMBRA_INLINE std::uint32_t bits(Mask a) { return static_cast<std::uint32_t>(_mm256_movemask_ps(raw(a))); }
PENUMBRA_INLINE bool any(Mask a) { return bits(a) != 0; }

PENUMBRA_INLINE Mask operator<(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v < b.v)); }
PENUMBRA_INLINE Mask operator<=(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v <= b.v)); }
PENUMBRA_INLINE Mask operator>(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v > b.v)); }
PENUMBRA_INLINE Mask operator>=(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v >= b.v)); }
PENUMBRA_INLINE Mask operator==(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v == b.v)); }
PENUMBRA_INLINE Mask operator!=(Floats a, Floats b) { return Mask(reinterpret_cast<UintVector>(a.v != b.v)); }
PENUMBRA_INLINE Mask operator==(Ints a, Ints b) { return Mask(reinterpret_cast<UintVector>(a.v == b.v)); }
PENUMBRA_INLINE Mask operator<(Ints a, Ints b) { return Mask(reinterpret_cast<UintVector>(a.v < b.v)); }

PENUMBRA_INLINE Mask mask_from_bits(std::uint32_t b) {
  constexpr UintVector lane_bit = {1, 2, 4, 8, 16, 32, 64, 128};
  return Mask(reinterpret_cast<UintVector>(((b - UintVector{}) & lane_bit) != 0));
}

PENUMBRA_INLINE Floats select(Mask m, Floats a, Floats b) { return Floats(_mm256_blendv_ps(b.v, a.v, raw(m))); }
PENUMBRA_INLINE Ints select(Mask m, Ints a, Ints b) { return Ints((a.v & m.m) | (b.v & ~m.m)); }

// As the instructions: where a number is not a number, the second.
PENUMBRA_INLINE Floats min(Floats a, Floats b) { return Floats(_mm256_min_ps(a.v, b.v)); }
PENUMBRA_INLINE Floats max(Floats a, Floats b) { return Floats(_mm256_max_ps(a.v, b.v)); }
PENUMBRA_INLINE Floats sqrt(Floats a) { return Floats(_mm256_sqrt_ps(a.v)); }
PENUMBRA_INLINE Floats round(Floats a) {
  return Floats(_mm256_round_ps(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}
PENUMBRA_INLINE Floats floor(Floats a) { return Floats(_mm256_floor_ps(a.v)); }
PENUMBRA_INLINE Ints truncate(Floats a) { return ints(_mm256_cvttps_epi32(a.v)); }

PENUMBRA_INLINE Floats gather(const float* base, Ints index) {
  return Floats(_mm256_i32gather_ps(base, raw(index), 4));
}
PENUMBRA_INLINE Ints gather(const std::uint32_t* base, Ints index) {
  return ints(_mm256_i32gather_epi32(reinterpret_cast<const int*>(base), raw(index), 4));
}

// All bits set in the lanes of the mask: what Embree calls valid.
PENUMBRA_INLINE Ints lane_bits(Mask m) { return Ints(m.m); }

}  // namespace penumbra::PENUMBRA_KERNEL
