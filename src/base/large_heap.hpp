#pragma once

#include <cstddef>

namespace penumbra {

inline constexpr std::size_t large_page = std::size_t{2} << 20;  // bytes, of the kernel's large pages

// Has the first 512 MB that malloc and new hand out, to all threads, lie in the kernel's large pages, where it has such
// and the process has no limit of memory. What is freed of them stays with the process. Nothing but speed depends on
// it. To be called once, before there is a second thread.
void use_large_heap();

}  // namespace penumbra
