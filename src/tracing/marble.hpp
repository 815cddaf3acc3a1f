// Solid marble (Perlin 1985): layers of grey that turbulence has folded. The sum of noise over octaves is taken as the
// height in a stack of layers, the same upwards and downwards; each layer is brightest in its middle and black at its
// edges, so that edges show as creases, soft where the height changes slowly and sharp where it changes fast.
#pragma once

#include "tracing/noise.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Noise at about doubling frequencies (not exactly, as its zeros would meet in the corners of the lattice) and about
// halving amplitudes.
inline Floats marble_height(Float3 p) {
  Floats sum = Floats(0);
  float frequency = 1.1f, amplitude = 1;
  for (int octave = 0; octave < 6; octave++) {
    sum += Floats(amplitude) * noise3(p * Floats(frequency));
    frequency *= 2.03f;
    amplitude *= 0.48f;
  }
  return sum;
}

// A layer from `begin` to `end` in the stack: 1 in its middle, 0 at its edges.
PENUMBRA_INLINE Floats marble_rise(Floats t, float begin, float end) {
  const Floats x = (t - Floats(begin)) * Floats(2 / (end - begin)) - Floats(1);
  return Floats(1) - x * x;
}

// The stack of layers repeats from 0 to 1: middle grey, bright, and two of dark grey. The lower edge of the middle grey
// is a soft one.
inline Floats marble_layers(Floats height) {
  const Floats t = height - floor(height);
  const Floats middle = select(t < Floats(0.26f), marble_rise(t, 0, 0.52f), marble_rise(t, 0.1f, 0.42f));
  const Floats bright = marble_rise(t, 0.42f, 0.7f);
  const Floats dark = select(t < Floats(0.9f), marble_rise(t, 0.7f, 0.9f), marble_rise(t, 0.9f, 1));
  return select(t < Floats(0.42f), Floats(0.52f) * middle,
                select(t < Floats(0.7f), Floats(0.71f) * bright, Floats(0.375f) * dark));
}

inline Floats marble_grey(Float3 p) { return marble_layers(abs(marble_height(p)) * Floats(1.6f)); }

}  // namespace penumbra::PENUMBRA_KERNEL
