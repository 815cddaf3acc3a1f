// Which instruction sets this program was built for and this machine can run.
#pragma once

#include <span>
#include <string_view>

#include "tracing/kernel.hpp"

namespace penumbra {

// All instruction sets, the narrowest first; each is the name of its kernel.
inline constexpr const char* isa_names[] = {"sse42", "avx2", "avx512"};

// The kernels that this program was built with, the narrowest first.
std::span<const Kernel* const> built_kernels();

// Those that can also run here. Empty if the program was built for wider machines only.
std::span<const Kernel* const> usable_kernels();

// The kernel of that name; null if there is none.
const Kernel* kernel_from_name(std::span<const Kernel* const> kernels, std::string_view isa);

}  // namespace penumbra
