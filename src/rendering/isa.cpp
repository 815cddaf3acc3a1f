#include "rendering/isa.hpp"

#include <vector>

namespace penumbra {

std::span<const Kernel* const> built_kernels() {
  static const std::vector<const Kernel*> kernels = {
#ifdef PENUMBRA_HAS_SSE42
      &lanes4::kernel,
#endif
#ifdef PENUMBRA_HAS_AVX2
      &lanes8::kernel,
#endif
#ifdef PENUMBRA_HAS_AVX512
      &lanes16::kernel,
#endif
  };
  return kernels;
}

std::span<const Kernel* const> usable_kernels() {
  static const std::vector<const Kernel*> kernels = [] {
    std::vector<const Kernel*> usable;
#ifdef PENUMBRA_HAS_SSE42
    if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt")) usable.push_back(&lanes4::kernel);
#endif
#ifdef PENUMBRA_HAS_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"))
      usable.push_back(&lanes8::kernel);
#endif
#ifdef PENUMBRA_HAS_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw")) {
      usable.push_back(&lanes16::kernel);
    }
#endif
    return usable;
  }();
  return kernels;
}

const Kernel* kernel_from_name(std::span<const Kernel* const> kernels, std::string_view isa) {
  for (const Kernel* kernel : kernels) {
    if (kernel->isa == isa) return kernel;
  }
  return nullptr;
}

}  // namespace penumbra
