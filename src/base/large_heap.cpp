// The heap's small pages come one by one, on a virtual machine at 16 us each, where a large page comes in 150 us: a
// start touches a hundred small ones, a scene of 100,000 spheres 20,000. The C library has a switch for this
// (glibc.malloc.hugetlb), but only in the environment; so its heap is grown here, before it is used.
#include "base/large_heap.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace penumbra {
namespace {

constexpr int heap_bytes = 512 << 20;
constexpr int largest_block = 32 << 20;  // of those that a full heap grows for: the most that the C library takes
constexpr int usual_growth = 128 << 10;

// What lies between the small pages that the heap has and its first large one. Never written to, never freed.
void* volatile in_the_way[2];

bool is_limited(int resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

// Whether memory counts for a limit before it is written to. The heap would then take from all else.
bool is_memory_counted_early() {
  if (is_limited(RLIMIT_AS) || is_limited(RLIMIT_DATA)) return true;
  char policy = '0';
  const int file = open("/proc/sys/vm/overcommit_memory", O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool is_read = read(file, &policy, 1) == 1;
  close(file);
  return is_read && policy == '2';
}

}  // namespace

void use_large_heap() {
  if (is_memory_counted_early()) return;
  // What is free at the end of the heap stays there: it would come back in small pages.
  if (mallopt(M_TRIM_THRESHOLD, -1) == 0) return;  // not the C library's heap, but that of a sanitizer
  mallopt(M_ARENA_MAX, 1);                         // or threads would have heaps of their own
  mallopt(M_MMAP_THRESHOLD, largest_block);
  mallopt(M_TOP_PAD, heap_bytes);
  in_the_way[0] = std::malloc(2 * usual_growth);  // more than is left of the first growth
  mallopt(M_TOP_PAD, usual_growth);
  if (!in_the_way[0]) return;
  const auto here = reinterpret_cast<std::uintptr_t>(in_the_way[0]) + malloc_usable_size(in_the_way[0]);
  const std::uintptr_t begin = (here + large_page - 1) / large_page * large_page;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / large_page * large_page;
  if (begin >= end || end - begin > heap_bytes + large_page) return;  // the heap is elsewhere, or somebody else's
  // Before the C library writes to the first of them.
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  in_the_way[1] = std::malloc(begin - here);
}

}  // namespace penumbra
