#include "app/machine_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "rendering/isa.hpp"

namespace penumbra {
namespace {

std::string names_of(std::span<const Kernel* const> kernels) {
  std::vector<std::string_view> names;
  for (const Kernel* kernel : kernels) names.emplace_back(kernel->isa);
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

const Kernel* kernel_for(const std::string& name) {
  if (const Kernel* kernel = kernel_from_name(usable_kernels(), name)) return kernel;
  if (std::find(std::begin(isa_names), std::end(isa_names), name) == std::end(isa_names)) {
    throw CLI::ValidationError(
        "--isa", fmt::format("there is no instruction set `{}`; there are {}", name, names_of(usable_kernels())));
  }
  if (!kernel_from_name(built_kernels(), name)) {
    throw CLI::ValidationError(
        "--isa", fmt::format("this program was not built for {}; there are {}", name, names_of(usable_kernels())));
  }
  throw CLI::ValidationError("--isa",
                             fmt::format("this machine cannot run {}; there are {}", name, names_of(usable_kernels())));
}

}  // namespace

void add_machine_options(CLI::App& command, int& threads, const Kernel*& kernel) {
  command.add_option("--threads", threads, "Threads [all processors this process may use]")->check(CLI::Range(1, 4096));
  command
      .add_option_function<std::string>(
          "--isa", [&kernel](const std::string& name) { kernel = kernel_for(name); },
          fmt::format("Instruction set: {} [the widest that can run here]", fmt::join(isa_names, ", ")))
      ->type_name("NAME");
}

}  // namespace penumbra
