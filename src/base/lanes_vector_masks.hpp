// Masks for instruction sets without mask registers: vectors of words, all ones or all zeros.
#pragma once

namespace penumbra::PENUMBRA_KERNEL::one {

using MaskVector = UintVector;

PENUMBRA_INLINE MaskVector mask_of(bool all) { return (all ? 0xffffffffu : 0u) - UintVector{}; }
PENUMBRA_INLINE MaskVector mask_from_bits(std::uint32_t b) {
  UintVector lane_bit;
  for (int lane = 0; lane < PENUMBRA_LANES; lane++) lane_bit[lane] = 1u << lane;
  return reinterpret_cast<MaskVector>(((b - UintVector{}) & lane_bit) != 0);
}
PENUMBRA_INLINE MaskVector both(MaskVector a, MaskVector b) { return a & b; }
PENUMBRA_INLINE MaskVector either(MaskVector a, MaskVector b) { return a | b; }
PENUMBRA_INLINE MaskVector complement(MaskVector a) { return ~a; }

PENUMBRA_INLINE MaskVector less(FloatVector a, FloatVector b) { return reinterpret_cast<MaskVector>(a < b); }
PENUMBRA_INLINE MaskVector not_above(FloatVector a, FloatVector b) { return reinterpret_cast<MaskVector>(a <= b); }
PENUMBRA_INLINE MaskVector equal(FloatVector a, FloatVector b) { return reinterpret_cast<MaskVector>(a == b); }
PENUMBRA_INLINE MaskVector unequal(FloatVector a, FloatVector b) { return reinterpret_cast<MaskVector>(a != b); }
PENUMBRA_INLINE MaskVector equal(UintVector a, UintVector b) { return reinterpret_cast<MaskVector>(a == b); }
PENUMBRA_INLINE MaskVector less(UintVector a, UintVector b) { return reinterpret_cast<MaskVector>(a < b); }

PENUMBRA_INLINE UintVector select(MaskVector m, UintVector a, UintVector b) { return (a & m) | (b & ~m); }
PENUMBRA_INLINE UintVector lane_bits(MaskVector m) { return m; }

}  // namespace penumbra::PENUMBRA_KERNEL::one
