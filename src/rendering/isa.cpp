#include "rendering/isa.hpp"

#include <vector>

namespace penumbra {

namespace {

// The kernels of this program, or those that this machine can run.
std::vector<const Kernel*> kernels(bool usable) {
  std::vector<const Kernel*> list;
  const auto add = [&](const Kernel& kernel, bool runs_here) {
    if (runs_here || !usable) list.push_back(&kernel);
  };
#ifdef PENUMBRA_HAS_SSE42
  add(lanes4::kernel, __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt"));
#endif
#ifdef PENUMBRA_HAS_AVX2
  add(lanes8::kernel,
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2"));
#endif
#ifdef PENUMBRA_HAS_AVX512
  add(lanes16::kernel, __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"));
#endif
  return list;
}

}  // namespace

std::span<const Kernel* const> built_kernels() {
  static const std::vector<const Kernel*> built = kernels(false);
  return built;
}

std::span<const Kernel* const> usable_kernels() {
  static const std::vector<const Kernel*> usable = kernels(true);
  return usable;
}

const Kernel* kernel_from_name(std::span<const Kernel* const> kernels, std::string_view isa) {
  for (const Kernel* kernel : kernels) {
    if (kernel->isa == isa) return kernel;
  }
  return nullptr;
}

}  // namespace penumbra
