#include "app/options/machine_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/thread_count.hpp"
#include "rendering/isa.hpp"

namespace penumbra {
namespace {

constexpr int most_threads = 4096;

std::string names_of(std::span<const Kernel* const> kernels) {
  std::vector<std::string_view> names;
  for (const Kernel* kernel : kernels) names.emplace_back(kernel->isa);
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::string take_isa(MachineOptions& options, std::string_view name) {
  options.kernel = kernel_from_name(usable_kernels(), name);
  if (options.kernel) return {};
  const std::string there_are = "there are " + names_of(usable_kernels());
  if (std::find(std::begin(isa_names), std::end(isa_names), name) == std::end(isa_names)) {
    return fmt::format("there is no instruction set `{}`; {}", name, there_are);
  }
  if (!kernel_from_name(built_kernels(), name)) {
    return fmt::format("this program was not built for {}; {}", name, there_are);
  }
  return fmt::format("this machine cannot run {}; {}", name, there_are);
}

}  // namespace

std::vector<CommandOption> machine_options(MachineOptions& options) {
  return {
      {"--threads", "N", "Threads [all processors this process may use]", into(options.threads, 1, most_threads)},
      {"--isa", "NAME", fmt::format("Instruction set: {} [the widest that can run here]", fmt::join(isa_names, ", ")),
       [&options](std::string_view name) { return take_isa(options, name); }}};
}

const Kernel* kernel_of(const MachineOptions& options) {
  if (options.kernel) return options.kernel;
  if (!usable_kernels().empty()) return usable_kernels().back();
  fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
  return nullptr;
}

int threads_of(const MachineOptions& options) { return options.threads > 0 ? options.threads : default_thread_count(); }

}  // namespace penumbra
