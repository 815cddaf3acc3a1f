// One vector of 16 lanes, for AVX-512 (F, BW, DQ, VL): masks are in mask registers.
#pragma once

namespace penumbra::PENUMBRA_KERNEL::one {

using MaskVector = __mmask16;

PENUMBRA_INLINE MaskVector mask_of(bool all) { return all ? 0xffff : 0; }
PENUMBRA_INLINE MaskVector mask_from_bits(std::uint32_t b) { return static_cast<MaskVector>(b); }
PENUMBRA_INLINE std::uint32_t bits(MaskVector a) { return a; }
PENUMBRA_INLINE MaskVector both(MaskVector a, MaskVector b) { return static_cast<MaskVector>(a & b); }
PENUMBRA_INLINE MaskVector either(MaskVector a, MaskVector b) { return static_cast<MaskVector>(a | b); }
PENUMBRA_INLINE MaskVector complement(MaskVector a) { return static_cast<MaskVector>(~a); }

PENUMBRA_INLINE __m512i raw(UintVector a) { return reinterpret_cast<__m512i>(a); }
PENUMBRA_INLINE UintVector words(__m512i a) { return reinterpret_cast<UintVector>(a); }

PENUMBRA_INLINE MaskVector less(FloatVector a, FloatVector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
PENUMBRA_INLINE MaskVector not_above(FloatVector a, FloatVector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
PENUMBRA_INLINE MaskVector equal(FloatVector a, FloatVector b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
PENUMBRA_INLINE MaskVector unequal(FloatVector a, FloatVector b) { return _mm512_cmp_ps_mask(a, b, _CMP_NEQ_UQ); }
PENUMBRA_INLINE MaskVector equal(UintVector a, UintVector b) { return _mm512_cmpeq_epi32_mask(raw(a), raw(b)); }
PENUMBRA_INLINE MaskVector less(UintVector a, UintVector b) { return _mm512_cmplt_epu32_mask(raw(a), raw(b)); }

PENUMBRA_INLINE FloatVector select(MaskVector m, FloatVector a, FloatVector b) { return _mm512_mask_blend_ps(m, b, a); }
PENUMBRA_INLINE UintVector select(MaskVector m, UintVector a, UintVector b) {
  return words(_mm512_mask_blend_epi32(m, raw(b), raw(a)));
}

PENUMBRA_INLINE FloatVector min(FloatVector a, FloatVector b) { return _mm512_min_ps(a, b); }
PENUMBRA_INLINE FloatVector max(FloatVector a, FloatVector b) { return _mm512_max_ps(a, b); }
PENUMBRA_INLINE UintVector max(UintVector a, UintVector b) { return words(_mm512_max_epu32(raw(a), raw(b))); }
PENUMBRA_INLINE FloatVector sqrt(FloatVector a) { return _mm512_sqrt_ps(a); }
PENUMBRA_INLINE FloatVector round(FloatVector a) { return _mm512_roundscale_ps(a, _MM_FROUND_TO_NEAREST_INT); }
PENUMBRA_INLINE FloatVector floor(FloatVector a) { return _mm512_roundscale_ps(a, _MM_FROUND_TO_NEG_INF); }
PENUMBRA_INLINE UintVector truncate(FloatVector a) { return words(_mm512_cvttps_epi32(a)); }

PENUMBRA_INLINE FloatVector gather(const float* base, UintVector index) {
  return _mm512_i32gather_ps(raw(index), base, 4);
}
PENUMBRA_INLINE UintVector gather(const std::uint32_t* base, UintVector index) {
  return words(_mm512_i32gather_epi32(raw(index), base, 4));
}

PENUMBRA_INLINE UintVector repeat(__m128i sixteen_bytes) { return words(_mm512_broadcast_i32x4(sixteen_bytes)); }
PENUMBRA_INLINE UintVector pick_bytes(UintVector bytes, UintVector where) {
  return words(_mm512_shuffle_epi8(raw(bytes), raw(where)));
}

PENUMBRA_INLINE UintVector lane_bits(MaskVector m) { return words(_mm512_movm_epi32(m)); }

}  // namespace penumbra::PENUMBRA_KERNEL::one
