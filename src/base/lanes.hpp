// W rays at a time: the SIMD vocabulary that everything traced per ray is written in. One lane is one ray.
//
// W comes from the build (PENUMBRA_LANES): a file that includes this is compiled once for each instruction set, each
// time into its own namespace, so that the linker can never merge code of two instruction sets. Every operation here is
// exact in the sense of IEEE 754 (no fused multiply-add, no reciprocal estimates) and gives the same bits for every W.
//
// Arithmetic is the compiler's own vector arithmetic; what it has no operator for (masks, square roots, gathers) is in
// one short file of intrinsics per instruction set.
#pragma once

#include <immintrin.h>

#include <cstdint>

#if PENUMBRA_LANES == 16
#define PENUMBRA_KERNEL lanes16
#elif PENUMBRA_LANES == 8
#define PENUMBRA_KERNEL lanes8
#elif PENUMBRA_LANES == 4
#define PENUMBRA_KERNEL lanes4
#else
#error "PENUMBRA_LANES must be 4, 8 or 16"
#endif

// Under the sanitizers, calls are left calls: inlined, the instrumented packets take minutes to compile.
#ifdef PENUMBRA_SANITIZED
#define PENUMBRA_INLINE inline
#else
#define PENUMBRA_INLINE inline __attribute__((always_inline))
#endif

namespace penumbra::PENUMBRA_KERNEL {

inline constexpr int lane_count = PENUMBRA_LANES;

using FloatVector = float __attribute__((vector_size(4 * PENUMBRA_LANES)));
using IntVector = std::int32_t __attribute__((vector_size(4 * PENUMBRA_LANES)));
using UintVector = std::uint32_t __attribute__((vector_size(4 * PENUMBRA_LANES)));

struct Mask;

// W single-precision numbers.
struct Floats {
  FloatVector v;

  PENUMBRA_INLINE Floats() = default;
  PENUMBRA_INLINE explicit Floats(FloatVector vector) : v(vector) {}
  PENUMBRA_INLINE Floats(float value) : v(value - FloatVector{}) {}  // NOLINT: a number stands for W of it
};

// W 32-bit integers, unsigned for shifts and wrap-around.
struct Ints {
  UintVector v;

  PENUMBRA_INLINE Ints() = default;
  PENUMBRA_INLINE explicit Ints(UintVector vector) : v(vector) {}
  PENUMBRA_INLINE Ints(std::uint32_t value) : v(value - UintVector{}) {}  // NOLINT: a number stands for W of it
};

}  // namespace penumbra::PENUMBRA_KERNEL

#if PENUMBRA_LANES == 16
#include "base/lanes_avx512.hpp"
#elif PENUMBRA_LANES == 8
#include "base/lanes_avx2.hpp"
#else
#include "base/lanes_sse42.hpp"
#endif

namespace penumbra::PENUMBRA_KERNEL {

PENUMBRA_INLINE Floats operator+(Floats a, Floats b) { return Floats(a.v + b.v); }
PENUMBRA_INLINE Floats operator-(Floats a, Floats b) { return Floats(a.v - b.v); }
PENUMBRA_INLINE Floats operator*(Floats a, Floats b) { return Floats(a.v * b.v); }
PENUMBRA_INLINE Floats operator/(Floats a, Floats b) { return Floats(a.v / b.v); }
PENUMBRA_INLINE Floats operator-(Floats a) { return Floats(-a.v); }
PENUMBRA_INLINE Floats& operator+=(Floats& a, Floats b) { return a = a + b; }
PENUMBRA_INLINE Floats& operator-=(Floats& a, Floats b) { return a = a - b; }
PENUMBRA_INLINE Floats& operator*=(Floats& a, Floats b) { return a = a * b; }

PENUMBRA_INLINE Ints operator+(Ints a, Ints b) { return Ints(a.v + b.v); }
PENUMBRA_INLINE Ints operator-(Ints a, Ints b) { return Ints(a.v - b.v); }
PENUMBRA_INLINE Ints operator*(Ints a, Ints b) { return Ints(a.v * b.v); }
PENUMBRA_INLINE Ints operator&(Ints a, Ints b) { return Ints(a.v & b.v); }
PENUMBRA_INLINE Ints operator|(Ints a, Ints b) { return Ints(a.v | b.v); }
PENUMBRA_INLINE Ints operator^(Ints a, Ints b) { return Ints(a.v ^ b.v); }
PENUMBRA_INLINE Ints operator<<(Ints a, int bits) { return Ints(a.v << bits); }
PENUMBRA_INLINE Ints operator>>(Ints a, int bits) { return Ints(a.v >> bits); }
PENUMBRA_INLINE Ints& operator^=(Ints& a, Ints b) { return a = a ^ b; }
PENUMBRA_INLINE Ints& operator+=(Ints& a, Ints b) { return a = a + b; }
PENUMBRA_INLINE Ints& operator*=(Ints& a, Ints b) { return a = a * b; }

PENUMBRA_INLINE Mask& operator&=(Mask& a, Mask b) { return a = a & b; }
PENUMBRA_INLINE Mask& operator|=(Mask& a, Mask b) { return a = a | b; }
PENUMBRA_INLINE bool none(Mask m) { return !any(m); }
PENUMBRA_INLINE int count(Mask m) { return __builtin_popcount(bits(m)); }

PENUMBRA_INLINE Floats as_floats(Ints a) { return Floats(reinterpret_cast<FloatVector>(a.v)); }
PENUMBRA_INLINE Ints as_ints(Floats a) { return Ints(reinterpret_cast<UintVector>(a.v)); }
PENUMBRA_INLINE Floats to_floats(Ints a) {
  return Floats(__builtin_convertvector(reinterpret_cast<IntVector>(a.v), FloatVector));
}

PENUMBRA_INLINE Floats load(const float* p) {
  Floats a;
  __builtin_memcpy(&a.v, p, sizeof a.v);
  return a;
}
PENUMBRA_INLINE Ints load(const std::uint32_t* p) {
  Ints a;
  __builtin_memcpy(&a.v, p, sizeof a.v);
  return a;
}
PENUMBRA_INLINE void store(float* p, Floats a) { __builtin_memcpy(p, &a.v, sizeof a.v); }
PENUMBRA_INLINE void store(std::uint32_t* p, Ints a) { __builtin_memcpy(p, &a.v, sizeof a.v); }

// Where the mask is set a, elsewhere zero.
PENUMBRA_INLINE Floats keep(Mask m, Floats a) { return select(m, a, Floats(0)); }

PENUMBRA_INLINE Floats abs(Floats a) { return as_floats(as_ints(a) & Ints(0x7fffffffu)); }
// The magnitude of a with the sign of b.
PENUMBRA_INLINE Floats copysign(Floats a, Floats b) {
  return as_floats((as_ints(a) & Ints(0x7fffffffu)) | (as_ints(b) & Ints(0x80000000u)));
}

// 0, 1, ..., W-1
PENUMBRA_INLINE Ints lane_numbers() {
  static constexpr std::uint32_t numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return load(numbers);
}

}  // namespace penumbra::PENUMBRA_KERNEL
