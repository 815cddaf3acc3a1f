// Sums of samples are exact because every term is a whole multiple of a small power of two, its quantum.
#pragma once

#include "base/lanes.hpp"

namespace penumbra::PENUMBRA_KERNEL {

// Adding and subtracting this rounds a double to a whole multiple of the quantum.
PENUMBRA_INLINE double rounder(double quantum) { return quantum * 6755399441055744.0; }  // 1.5 * 2^52

}  // namespace penumbra::PENUMBRA_KERNEL
