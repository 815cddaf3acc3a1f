#include "base/thread_count.hpp"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace penumbra {
namespace {

struct FreeCpuSet {
  void operator()(cpu_set_t* set) const { CPU_FREE(set); }
};

}  // namespace

int default_thread_count() {
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK")) {
    int count = 0;
    const char* end = slurm + std::strlen(slurm);
    if (std::from_chars(slurm, end, count).ptr == end && count > 0) return count;
  }
  // Machines with more processors than cpu_set_t has places need a larger mask.
  for (int places = CPU_SETSIZE; places <= 1 << 20; places *= 2) {
    const std::unique_ptr<cpu_set_t, FreeCpuSet> allowed(CPU_ALLOC(places));
    const std::size_t size = CPU_ALLOC_SIZE(places);
    if (allowed && sched_getaffinity(0, size, allowed.get()) == 0) return std::max(CPU_COUNT_S(size, allowed.get()), 1);
  }
  return 1;
}

}  // namespace penumbra
