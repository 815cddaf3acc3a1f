// W rays at a time: the SIMD vocabulary that everything traced per ray is written in. One lane is one ray.
//
// A packet is two vectors of the instruction set, because most steps of a ray wait for the one before: with two vectors
// the processor has twice as much to do meanwhile. The vector length comes from the build (PENUMBRA_LANES): a file that
// includes this is compiled once for each instruction set, each time into its own namespace, so that the linker can
// never merge code of two instruction sets. Every operation here is exact in the sense of IEEE 754 (no fused
// multiply-add, no reciprocal estimates) and gives the same bits for every W.
//
// Arithmetic is the compiler's own vector arithmetic; what it has no operator for (masks, square roots, gathers) is in
// one short file of intrinsics per instruction set.
#pragma once

#include <immintrin.h>

#include <cstdint>

#if PENUMBRA_LANES == 16
#define PENUMBRA_LANES_NAME lanes16
#elif PENUMBRA_LANES == 8
#define PENUMBRA_LANES_NAME lanes8
#elif PENUMBRA_LANES == 4
#define PENUMBRA_LANES_NAME lanes4
#else
#error "PENUMBRA_LANES must be 4, 8 or 16"
#endif

// Defined by the file that records rays (tracing/recording.cpp): there, everything is in another namespace.
#ifdef PENUMBRA_RECORDS
#define PENUMBRA_KERNEL PENUMBRA_LANES_NAME::recording
#else
#define PENUMBRA_KERNEL PENUMBRA_LANES_NAME
#endif

// Under the sanitizers nothing is forced inline: the instrumented packets would take minutes to compile.
#ifdef PENUMBRA_SANITIZED
#define PENUMBRA_INLINE inline
#else
#define PENUMBRA_INLINE inline __attribute__((always_inline))
#endif

namespace penumbra::PENUMBRA_KERNEL {

inline constexpr int vector_lanes = PENUMBRA_LANES;
inline constexpr int lane_count = 2 * vector_lanes;

using FloatVector = float __attribute__((vector_size(4 * PENUMBRA_LANES)));
using IntVector = std::int32_t __attribute__((vector_size(4 * PENUMBRA_LANES)));
using UintVector = std::uint32_t __attribute__((vector_size(4 * PENUMBRA_LANES)));

}  // namespace penumbra::PENUMBRA_KERNEL

#if PENUMBRA_LANES == 16
#include "base/lanes_avx512.hpp"
#elif PENUMBRA_LANES == 8
#include "base/lanes_avx2.hpp"
#else
#include "base/lanes_sse42.hpp"
#endif

namespace penumbra::PENUMBRA_KERNEL {

// W single-precision numbers.
struct Floats {
  FloatVector lo, hi;

  PENUMBRA_INLINE Floats() = default;
  PENUMBRA_INLINE Floats(FloatVector low, FloatVector high) : lo(low), hi(high) {}
  PENUMBRA_INLINE Floats(float value) : lo(value - FloatVector{}), hi(lo) {}  // NOLINT: a number stands for W copies
};

// W 32-bit integers, unsigned for shifts and wrap-around.
struct Ints {
  UintVector lo, hi;

  PENUMBRA_INLINE Ints() = default;
  PENUMBRA_INLINE Ints(UintVector low, UintVector high) : lo(low), hi(high) {}
  PENUMBRA_INLINE Ints(std::uint32_t value) : lo(value - UintVector{}), hi(lo) {}  // NOLINT: likewise
};

// One number for each vector of a packet.
PENUMBRA_INLINE Ints halves(std::uint32_t low, std::uint32_t high) { return {Ints(low).lo, Ints(high).lo}; }

// W truth values.
struct Mask {
  one::MaskVector lo, hi;

  PENUMBRA_INLINE Mask() = default;
  PENUMBRA_INLINE Mask(one::MaskVector low, one::MaskVector high) : lo(low), hi(high) {}
  PENUMBRA_INLINE explicit Mask(bool all) : lo(one::mask_of(all)), hi(lo) {}
};

PENUMBRA_INLINE Floats operator+(Floats a, Floats b) { return {a.lo + b.lo, a.hi + b.hi}; }
PENUMBRA_INLINE Floats operator-(Floats a, Floats b) { return {a.lo - b.lo, a.hi - b.hi}; }
PENUMBRA_INLINE Floats operator*(Floats a, Floats b) { return {a.lo * b.lo, a.hi * b.hi}; }
PENUMBRA_INLINE Floats operator/(Floats a, Floats b) { return {a.lo / b.lo, a.hi / b.hi}; }
PENUMBRA_INLINE Floats operator-(Floats a) { return {-a.lo, -a.hi}; }
PENUMBRA_INLINE Floats& operator+=(Floats& a, Floats b) { return a = a + b; }
PENUMBRA_INLINE Floats& operator-=(Floats& a, Floats b) { return a = a - b; }
PENUMBRA_INLINE Floats& operator*=(Floats& a, Floats b) { return a = a * b; }

PENUMBRA_INLINE Ints operator+(Ints a, Ints b) { return {a.lo + b.lo, a.hi + b.hi}; }
PENUMBRA_INLINE Ints operator-(Ints a, Ints b) { return {a.lo - b.lo, a.hi - b.hi}; }
PENUMBRA_INLINE Ints operator*(Ints a, Ints b) { return {a.lo * b.lo, a.hi * b.hi}; }
PENUMBRA_INLINE Ints operator&(Ints a, Ints b) { return {a.lo & b.lo, a.hi & b.hi}; }
PENUMBRA_INLINE Ints operator|(Ints a, Ints b) { return {a.lo | b.lo, a.hi | b.hi}; }
PENUMBRA_INLINE Ints operator^(Ints a, Ints b) { return {a.lo ^ b.lo, a.hi ^ b.hi}; }
PENUMBRA_INLINE Ints operator<<(Ints a, int bits) { return {a.lo << bits, a.hi << bits}; }
PENUMBRA_INLINE Ints operator>>(Ints a, int bits) { return {a.lo >> bits, a.hi >> bits}; }
PENUMBRA_INLINE Ints& operator^=(Ints& a, Ints b) { return a = a ^ b; }
PENUMBRA_INLINE Ints& operator+=(Ints& a, Ints b) { return a = a + b; }
PENUMBRA_INLINE Ints& operator*=(Ints& a, Ints b) { return a = a * b; }

PENUMBRA_INLINE Mask operator&(Mask a, Mask b) { return {one::both(a.lo, b.lo), one::both(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator|(Mask a, Mask b) { return {one::either(a.lo, b.lo), one::either(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator~(Mask a) { return {one::complement(a.lo), one::complement(a.hi)}; }
PENUMBRA_INLINE Mask& operator&=(Mask& a, Mask b) { return a = a & b; }
PENUMBRA_INLINE Mask& operator|=(Mask& a, Mask b) { return a = a | b; }

// One bit per lane, lane 0 lowest.
PENUMBRA_INLINE std::uint32_t bits(Mask m) { return one::bits(m.lo) | (one::bits(m.hi) << vector_lanes); }
PENUMBRA_INLINE Mask mask_from_bits(std::uint32_t b) {
  return {one::mask_from_bits(b), one::mask_from_bits(b >> vector_lanes)};
}
PENUMBRA_INLINE bool any(Mask m) { return one::bits(one::either(m.lo, m.hi)) != 0; }
PENUMBRA_INLINE bool none(Mask m) { return !any(m); }
PENUMBRA_INLINE int count(Mask m) { return __builtin_popcount(bits(m)); }

PENUMBRA_INLINE Mask operator<(Floats a, Floats b) { return {one::less(a.lo, b.lo), one::less(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator<=(Floats a, Floats b) { return {one::not_above(a.lo, b.lo), one::not_above(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator>(Floats a, Floats b) { return b < a; }
PENUMBRA_INLINE Mask operator>=(Floats a, Floats b) { return b <= a; }
PENUMBRA_INLINE Mask operator==(Floats a, Floats b) { return {one::equal(a.lo, b.lo), one::equal(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator!=(Floats a, Floats b) { return {one::unequal(a.lo, b.lo), one::unequal(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator==(Ints a, Ints b) { return {one::equal(a.lo, b.lo), one::equal(a.hi, b.hi)}; }
PENUMBRA_INLINE Mask operator<(Ints a, Ints b) { return {one::less(a.lo, b.lo), one::less(a.hi, b.hi)}; }

// a where the mask is set, b elsewhere.
PENUMBRA_INLINE Floats select(Mask m, Floats a, Floats b) {
  return {one::select(m.lo, a.lo, b.lo), one::select(m.hi, a.hi, b.hi)};
}
PENUMBRA_INLINE Ints select(Mask m, Ints a, Ints b) {
  return {one::select(m.lo, a.lo, b.lo), one::select(m.hi, a.hi, b.hi)};
}
// a where the mask is set, zero elsewhere.
PENUMBRA_INLINE Floats keep(Mask m, Floats a) { return select(m, a, Floats(0)); }

// Like the instructions: if either operand is NaN, the result is the second.
PENUMBRA_INLINE Floats min(Floats a, Floats b) { return {one::min(a.lo, b.lo), one::min(a.hi, b.hi)}; }
PENUMBRA_INLINE Floats max(Floats a, Floats b) { return {one::max(a.lo, b.lo), one::max(a.hi, b.hi)}; }
PENUMBRA_INLINE Ints max(Ints a, Ints b) { return {one::max(a.lo, b.lo), one::max(a.hi, b.hi)}; }
PENUMBRA_INLINE Floats sqrt(Floats a) { return {one::sqrt(a.lo), one::sqrt(a.hi)}; }
PENUMBRA_INLINE Floats round(Floats a) { return {one::round(a.lo), one::round(a.hi)}; }
PENUMBRA_INLINE Floats floor(Floats a) { return {one::floor(a.lo), one::floor(a.hi)}; }
PENUMBRA_INLINE Ints truncate(Floats a) { return {one::truncate(a.lo), one::truncate(a.hi)}; }

PENUMBRA_INLINE Floats as_floats(Ints a) {
  return {reinterpret_cast<FloatVector>(a.lo), reinterpret_cast<FloatVector>(a.hi)};
}
PENUMBRA_INLINE Ints as_ints(Floats a) {
  return {reinterpret_cast<UintVector>(a.lo), reinterpret_cast<UintVector>(a.hi)};
}
PENUMBRA_INLINE Floats to_floats(Ints a) {
  return {__builtin_convertvector(reinterpret_cast<IntVector>(a.lo), FloatVector),
          __builtin_convertvector(reinterpret_cast<IntVector>(a.hi), FloatVector)};
}

template <typename Lanes, typename Number>
PENUMBRA_INLINE Lanes load_lanes(const Number* low, const Number* high) {
  Lanes a;
  __builtin_memcpy(&a.lo, low, sizeof a.lo);
  __builtin_memcpy(&a.hi, high, sizeof a.hi);
  return a;
}
PENUMBRA_INLINE Floats load(const float* p) { return load_lanes<Floats>(p, p + vector_lanes); }
PENUMBRA_INLINE Ints load(const std::uint32_t* p) { return load_lanes<Ints>(p, p + vector_lanes); }
// Loads one vector into both vectors of a packet.
PENUMBRA_INLINE Ints load_twice(const std::uint32_t* p) { return load_lanes<Ints>(p, p); }
template <typename Lanes, typename Number>
PENUMBRA_INLINE void store(Number* p, Lanes a) {
  __builtin_memcpy(p, &a.lo, sizeof a.lo);
  __builtin_memcpy(p + vector_lanes, &a.hi, sizeof a.hi);
}

PENUMBRA_INLINE Floats gather(const float* base, Ints index) {
  return {one::gather(base, index.lo), one::gather(base, index.hi)};
}
PENUMBRA_INLINE Ints gather(const std::uint32_t* base, Ints index) {
  return {one::gather(base, index.lo), one::gather(base, index.hi)};
}

// Four words, repeated.
PENUMBRA_INLINE Ints sixteen_bytes(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const UintVector v =
      one::repeat(_mm_setr_epi32(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c), static_cast<int>(d)));
  return {v, v};
}
// Within each 16 bytes, byte i of the result is byte where[i] of `bytes`.
PENUMBRA_INLINE Ints pick_bytes(Ints bytes, Ints where) {
  return {one::pick_bytes(bytes.lo, where.lo), one::pick_bytes(bytes.hi, where.hi)};
}

// All bits set in the lanes of the mask, as Embree marks valid rays.
PENUMBRA_INLINE Ints lane_bits(Mask m) { return {one::lane_bits(m.lo), one::lane_bits(m.hi)}; }

PENUMBRA_INLINE Floats abs(Floats a) { return as_floats(as_ints(a) & Ints(0x7fffffffu)); }
// The magnitude of a with the sign of b.
PENUMBRA_INLINE Floats copysign(Floats a, Floats b) {
  return as_floats((as_ints(a) & Ints(0x7fffffffu)) | (as_ints(b) & Ints(0x80000000u)));
}

// 0, 1, ..., W-1
PENUMBRA_INLINE Ints lane_numbers() {
  static constexpr std::uint32_t numbers[32] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
                                                16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
  return load(numbers);
}

}  // namespace penumbra::PENUMBRA_KERNEL
