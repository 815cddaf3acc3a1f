// The permutation of 0..255 that Perlin published with his noise (1985, 2002), twice in a row plus what an index may
// run over: the look-ups need no wrapping.
#pragma once

#include <cstdint>

namespace penumbra {

extern const std::uint32_t noise_permutation[514];

// The same modulo 12: which gradient.
extern const std::uint32_t noise_gradient[514];

}  // namespace penumbra
