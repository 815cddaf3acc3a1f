// The operations of lanes.hpp that need intrinsics, for AVX-512 (F, DQ, VL): 16 lanes, masks in mask registers.
#pragma once

namespace penumbra::PENUMBRA_KERNEL {

struct Mask {
  __mmask16 m;

  PENUMBRA_INLINE Mask() = default;
  PENUMBRA_INLINE explicit Mask(__mmask16 mask) : m(mask) {}
  PENUMBRA_INLINE explicit Mask(bool all) : m(all ? 0xffff : 0) {}
};

PENUMBRA_INLINE Mask operator&(Mask a, Mask b) { return Mask(static_cast<__mmask16>(a.m & b.m)); }
PENUMBRA_INLINE Mask operator|(Mask a, Mask b) { return Mask(static_cast<__mmask16>(a.m | b.m)); }
PENUMBRA_INLINE Mask operator~(Mask a) { return Mask(static_cast<__mmask16>(~a.m)); }
PENUMBRA_INLINE std::uint32_t bits(Mask a) { return a.m; }
PENUMBRA_INLINE Mask mask_from_bits(std::uint32_t b) { return Mask(static_cast<__mmask16>(b)); }
PENUMBRA_INLINE bool any(Mask a) { return a.m != 0; }

PENUMBRA_INLINE __m512i raw(Ints a) { return reinterpret_cast<__m512i>(a.v); }
PENUMBRA_INLINE Ints ints(__m512i a) { return Ints(reinterpret_cast<UintVector>(a)); }

PENUMBRA_INLINE Mask operator<(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)); }
PENUMBRA_INLINE Mask operator<=(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)); }
PENUMBRA_INLINE Mask operator>(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)); }
PENUMBRA_INLINE Mask operator>=(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_GE_OQ)); }
PENUMBRA_INLINE Mask operator==(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_EQ_OQ)); }
PENUMBRA_INLINE Mask operator!=(Floats a, Floats b) { return Mask(_mm512_cmp_ps_mask(a.v, b.v, _CMP_NEQ_UQ)); }
PENUMBRA_INLINE Mask operator==(Ints a, Ints b) { return Mask(_mm512_cmpeq_epi32_mask(raw(a), raw(b))); }
PENUMBRA_INLINE Mask operator<(Ints a, Ints b) { return Mask(_mm512_cmplt_epu32_mask(raw(a), raw(b))); }

PENUMBRA_INLINE Floats select(Mask m, Floats a, Floats b) { return Floats(_mm512_mask_blend_ps(m.m, b.v, a.v)); }
PENUMBRA_INLINE Ints select(Mask m, Ints a, Ints b) { return ints(_mm512_mask_blend_epi32(m.m, raw(b), raw(a))); }

// As the instructions: where a number is not a number, the second.
PENUMBRA_INLINE Floats min(Floats a, Floats b) { return Floats(_mm512_min_ps(a.v, b.v)); }
PENUMBRA_INLINE Floats max(Floats a, Floats b) { return Floats(_mm512_max_ps(a.v, b.v)); }
PENUMBRA_INLINE Floats sqrt(Floats a) { return Floats(_mm512_sqrt_ps(a.v)); }
PENUMBRA_INLINE Floats round(Floats a) { return Floats(_mm512_roundscale_ps(a.v, _MM_FROUND_TO_NEAREST_INT)); }
PENUMBRA_INLINE Floats floor(Floats a) { return Floats(_mm512_roundscale_ps(a.v, _MM_FROUND_TO_NEG_INF)); }
PENUMBRA_INLINE Ints truncate(Floats a) { return ints(_mm512_cvttps_epi32(a.v)); }

PENUMBRA_INLINE Floats gather(const float* base, Ints index) {
  return Floats(_mm512_i32gather_ps(raw(index), base, 4));
}
PENUMBRA_INLINE Ints gather(const std::uint32_t* base, Ints index) {
  return ints(_mm512_i32gather_epi32(raw(index), base, 4));
}

// All bits set in the lanes of the mask: what Embree calls valid.
PENUMBRA_INLINE Ints lane_bits(Mask m) { return ints(_mm512_movm_epi32(m.m)); }

}  // namespace penumbra::PENUMBRA_KERNEL
