// One vector of 8 lanes, for AVX2.
#pragma once

#include "base/lanes_vector_masks.hpp"

namespace penumbra::PENUMBRA_KERNEL::one {

PENUMBRA_INLINE __m256i raw(UintVector a) { return reinterpret_cast<__m256i>(a); }
PENUMBRA_INLINE UintVector words(__m256i a) { return reinterpret_cast<UintVector>(a); }

PENUMBRA_INLINE std::uint32_t bits(MaskVector a) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(a)));
}
PENUMBRA_INLINE FloatVector select(MaskVector m, FloatVector a, FloatVector b) {
  return _mm256_blendv_ps(b, a, reinterpret_cast<__m256>(m));
}

PENUMBRA_INLINE FloatVector min(FloatVector a, FloatVector b) { return _mm256_min_ps(a, b); }
PENUMBRA_INLINE FloatVector max(FloatVector a, FloatVector b) { return _mm256_max_ps(a, b); }
PENUMBRA_INLINE UintVector max(UintVector a, UintVector b) { return words(_mm256_max_epu32(raw(a), raw(b))); }
PENUMBRA_INLINE FloatVector sqrt(FloatVector a) { return _mm256_sqrt_ps(a); }
PENUMBRA_INLINE FloatVector round(FloatVector a) {
  return _mm256_round_ps(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
PENUMBRA_INLINE FloatVector floor(FloatVector a) { return _mm256_floor_ps(a); }
PENUMBRA_INLINE UintVector truncate(FloatVector a) { return words(_mm256_cvttps_epi32(a)); }

PENUMBRA_INLINE FloatVector gather(const float* base, UintVector index) {
  return _mm256_i32gather_ps(base, raw(index), 4);
}
PENUMBRA_INLINE UintVector gather(const std::uint32_t* base, UintVector index) {
  return words(_mm256_i32gather_epi32(reinterpret_cast<const int*>(base), raw(index), 4));
}

PENUMBRA_INLINE UintVector repeat(__m128i sixteen_bytes) { return words(_mm256_broadcastsi128_si256(sixteen_bytes)); }
PENUMBRA_INLINE UintVector pick_bytes(UintVector bytes, UintVector where) {
  return words(_mm256_shuffle_epi8(raw(bytes), raw(where)));
}

}  // namespace penumbra::PENUMBRA_KERNEL::one
