// The heap's small pages come one by one, at 1 us each on a bare machine and at 16 us each on a virtual one, where a
// large page comes in 150 us: a start touches a hundred small ones, a scene of 100,000 spheres 20,000. The C library
// has a switch for this (glibc.malloc.hugetlb), but only in the environment; so its heap is grown here, before it is
// used.
#include "base/large_heap.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace penumbra {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;
constexpr int heap_bytes = 512 << 20;
constexpr int largest_block = 32 << 20;  // in the heap: the most that the C library takes
constexpr int usual_growth = 128 << 10;

// What lies between the small pages that the heap has and its first large one. Never written to, never freed.
void* volatile in_the_way[2];

}  // namespace

void use_large_heap() {
  // What is free at the end of the heap stays there, or it would come back in small pages.
  if (mallopt(M_TRIM_THRESHOLD, heap_bytes + largest_block) == 0) return;  // a sanitizer's heap
  mallopt(M_MMAP_THRESHOLD, largest_block);
  mallopt(M_TOP_PAD, heap_bytes);
  in_the_way[0] = std::malloc(2 * usual_growth);  // more than is left of the first growth
  mallopt(M_TOP_PAD, usual_growth);
  if (!in_the_way[0]) return;
  const auto here = reinterpret_cast<std::uintptr_t>(in_the_way[0]) + malloc_usable_size(in_the_way[0]);
  const std::uintptr_t begin = (here + large_page - 1) / large_page * large_page;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / large_page * large_page;
  if (begin >= end) return;  // the heap could not be grown in place
  // Before the C library writes to the first of them.
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  in_the_way[1] = std::malloc(begin - here);
}

}  // namespace penumbra
