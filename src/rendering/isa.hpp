// Which instruction sets this program was built for and this machine can run.
#pragma once

#include <span>

#include "tracing/kernel.hpp"

namespace penumbra {

// The kernels that can run here, the narrowest first. Empty if the program was built for wider machines only.
std::span<const Kernel* const> usable_kernels();

}  // namespace penumbra
