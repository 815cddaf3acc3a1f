// Vectors and elementary functions of W lanes. The functions are our own, from + - * / and sqrt alone: those of the C
// library give different bits on machines with and without fused multiply-add. Stated errors are the largest measured.
#pragma once

#include "base/lanes.hpp"

namespace penumbra::PENUMBRA_KERNEL {

struct Float3 {
  Floats x, y, z;
};

PENUMBRA_INLINE Float3 operator+(Float3 a, Float3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PENUMBRA_INLINE Float3 operator-(Float3 a, Float3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PENUMBRA_INLINE Float3 operator-(Float3 a) { return {-a.x, -a.y, -a.z}; }
PENUMBRA_INLINE Float3 operator*(Float3 a, Float3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
PENUMBRA_INLINE Float3 operator*(Float3 a, Floats s) { return {a.x * s, a.y * s, a.z * s}; }
PENUMBRA_INLINE Float3& operator+=(Float3& a, Float3 b) { return a = a + b; }
PENUMBRA_INLINE Float3& operator*=(Float3& a, Floats s) { return a = a * s; }

PENUMBRA_INLINE Floats dot(Float3 a, Float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
PENUMBRA_INLINE Float3 cross(Float3 a, Float3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PENUMBRA_INLINE Float3 select(Mask m, Float3 a, Float3 b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
PENUMBRA_INLINE Float3 keep(Mask m, Float3 a) { return {keep(m, a.x), keep(m, a.y), keep(m, a.z)}; }

// The unit vector along a; NaN where a is zero.
PENUMBRA_INLINE Float3 normalize(Float3 a) { return a * (Floats(1) / sqrt(dot(a, a))); }

// The same for vectors whose squares may overflow or underflow, such as normals under a matrix that flattens.
PENUMBRA_INLINE Float3 normalize_any_length(Float3 a) {
  const Mask usual = (dot(a, a) > Floats(1e-30f)) & (dot(a, a) < Floats(1e30f));
  if (any(~usual)) {
    const Floats largest = max(max(abs(a.x), abs(a.y)), abs(a.z));
    a = select(usual, a, {a.x / largest, a.y / largest, a.z / largest});
  }
  return normalize(a);
}

// W copies of three numbers in memory.
PENUMBRA_INLINE Float3 broadcast3(const float* p) { return {Floats(p[0]), Floats(p[1]), Floats(p[2])}; }

struct SinCos {
  Floats sine, cosine;
};

// Sine and cosine of u turns (2 pi u), |u| < 2^20; absolute error below 1.2e-7. Quarter turns by symmetry, then
// polynomials with minimax coefficients over an eighth of a turn to each side (Cephes, Moshier 1989).
PENUMBRA_INLINE SinCos sincos_turns(Floats u) {
  const Floats quarter = round(u * Floats(4));
  const Floats x = (u - quarter * Floats(0.25f)) * Floats(6.28318530717958648f);
  const Floats x2 = x * x;
  const Floats s =
      ((Floats(-1.9515295891e-4f) * x2 + Floats(8.3321608736e-3f)) * x2 + Floats(-1.6666654611e-1f)) * x2 * x + x;
  const Floats c =
      ((Floats(2.443315711809948e-5f) * x2 + Floats(-1.388731625493765e-3f)) * x2 + Floats(4.166664568298827e-2f)) *
          x2 * x2 -
      Floats(0.5f) * x2 + Floats(1);
  const Ints k = truncate(quarter);
  const Mask odd = (k & Ints(1)) == Ints(1);
  const Ints sine_sign = (k & Ints(2)) << 30;
  const Ints cosine_sign = ((k + Ints(1)) & Ints(2)) << 30;
  return {as_floats(as_ints(select(odd, c, s)) ^ sine_sign), as_floats(as_ints(select(odd, s, c)) ^ cosine_sign)};
}

// Logarithm to base 2 of a positive normal number; error below 2e-7 times the larger of 1 and |result|. The mantissa is
// scaled to [sqrt(1/2), sqrt(2)) and log2 computed by the series of the inverse hyperbolic tangent.
PENUMBRA_INLINE Floats log2(Floats a) {
  const Ints shifted = as_ints(a) - Ints(0x3f3504f3u);  // bits of sqrt(1/2)
  const Ints exponent_bits = shifted & Ints(0xff800000u);
  const Floats mantissa = as_floats(as_ints(a) - exponent_bits);
  const Floats exponent = to_floats(exponent_bits) * Floats(1.0f / 8388608.0f);
  const Floats t = (mantissa - Floats(1)) / (mantissa + Floats(1));
  const Floats t2 = t * t;
  const Floats series = ((Floats(0.41219858311f) * t2 + Floats(0.57707801635f)) * t2 + Floats(0.96179669392f)) * t2;
  return exponent + (series * t + t * Floats(2.88539008178f));
}

// 2 to the power of a, clamped to [-126, 126]; relative error below 2.5e-7.
PENUMBRA_INLINE Floats exp2(Floats a) {
  const Floats clamped = min(max(a, Floats(-126)), Floats(126));
  const Floats whole = round(clamped);
  const Floats r = clamped - whole;
  const Floats p = (((((Floats(1.5403530394e-4f) * r + Floats(1.3333558146e-3f)) * r + Floats(9.6181291077e-3f)) * r +
                      Floats(5.5504108665e-2f)) *
                         r +
                     Floats(2.4022650696e-1f)) *
                        r +
                    Floats(6.9314718056e-1f)) *
                       r +
                   Floats(1);
  return p * as_floats((truncate(whole) + Ints(127)) << 23);
}

// base^exponent for base >= 0; 0^0 is 1, and results below 2^-126 are 0.
PENUMBRA_INLINE Floats pow(Floats base, Floats exponent) {
  const Mask tiny = base < Floats(1.17549435e-38f);
  const Floats y = exponent * log2(select(tiny, Floats(1), base));
  const Floats power = keep(y >= Floats(-126), exp2(y));
  return select(exponent == Floats(0), Floats(1), keep(~tiny, power));
}

// base^exponent for an integer exponent > 0, by repeated squaring; relative error below exponent * 2^-24. Both
// overloads multiply in the same order, so they give the same bits.
PENUMBRA_INLINE Floats whole_power(Floats base, std::uint32_t exponent) {
  Floats result = Floats(1);
  for (; exponent != 0; exponent >>= 1, base *= base) {
    if ((exponent & 1) != 0) result *= base;
  }
  return result;
}
PENUMBRA_INLINE Floats whole_power(Floats base, Ints exponent) {
  Floats result = Floats(1);
  for (; any(~(exponent == Ints(0u))); exponent = exponent >> 1, base *= base) {
    result = select((exponent & Ints(1u)) == Ints(1u), result * base, result);
  }
  return result;
}

// Arc cosine in turns (acos(x) / 2 pi) for x in [-1, 1]; absolute error below 1e-7 turns. Abramowitz and Stegun 4.4.46.
PENUMBRA_INLINE Floats acos_turns(Floats x) {
  const Floats a = abs(x);
  Floats p = Floats(-0.0012624911f);
  p = p * a + Floats(0.0066700901f);
  p = p * a + Floats(-0.0170881256f);
  p = p * a + Floats(0.0308918810f);
  p = p * a + Floats(-0.0501743046f);
  p = p * a + Floats(0.0889789874f);
  p = p * a + Floats(-0.2145988016f);
  p = p * a + Floats(1.5707963050f);
  const Floats right = p * sqrt(max(Floats(1) - a, Floats(0))) * Floats(0.159154943f);
  return select(x < Floats(0), Floats(0.5f) - right, right);
}

}  // namespace penumbra::PENUMBRA_KERNEL
