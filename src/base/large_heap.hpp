#pragma once

namespace penumbra {

// Has the first 512 MB that malloc and new hand out lie in the kernel's large pages, where it has such: a wish, nothing
// but speed depends on it. To be called once, before there is a second thread.
void use_large_heap();

}  // namespace penumbra
