#include "app/options/shared_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "base/parse.hpp"
#include "base/say.hpp"
#include "picture/option_table.hpp"
#include "rendering/isa.hpp"

namespace penumbra {
namespace {

constexpr int most_threads = 4096;

struct FreeCpuSet {
  void operator()(cpu_set_t* set) const { CPU_FREE(set); }
};

// What Slurm gives the task, else the processors this process may use.
int default_thread_count() {
  if (const char* slurm = std::getenv("SLURM_CPUS_PER_TASK")) {
    if (const auto count = number_from<int>(slurm); count && *count > 0) return *count;
  }
  // Machines with more processors than cpu_set_t has places need a larger mask.
  for (int places = CPU_SETSIZE; places <= 1 << 20; places *= 2) {
    const std::unique_ptr<cpu_set_t, FreeCpuSet> allowed(CPU_ALLOC(places));
    const std::size_t size = CPU_ALLOC_SIZE(places);
    if (allowed && sched_getaffinity(0, size, allowed.get()) == 0) return std::max(CPU_COUNT_S(size, allowed.get()), 1);
  }
  return 1;
}

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

CommandOption command_option(const PictureOption& row, PictureOptions& options) {
  CommandOption option;
  option.name = "--" + std::string(row.name);
  option.metavar = row.metavar;
  option.help = row.help;
  option.take = [&row, &options](std::string_view text) { return parse_option(row, options, text); };
  if (row.is_list) option.times = Times::repeated;
  if (row.value_is_optional) option.times = Times::equals_optional;
  return option;
}

}  // namespace

std::vector<CommandOption> picture_options(PictureOptions& options, bool of_window) {
  std::vector<CommandOption> result;
  for (const PictureOption& row : option_table()) {
    if (of_window && row.use != OptionUse::everywhere) continue;
    result.push_back(command_option(row, options));
    if (of_window && !row.help_of_view.empty()) result.back().help = row.help_of_view;
  }
  return result;
}

CommandOption picture_option(PictureOptions& options, std::string_view name) {
  return command_option(option_named(name), options);
}

CommandOption paths_option(PictureOptions& options) {
  return {"--allow-paths", "", "Let the scene read files outside its folder, and write outside the working one [off]",
          into(options.allow_paths)};
}

std::vector<CommandOption> machine_options(MachineOptions& options) {
  return {
      {"--threads", "N", "Threads [all processors this process may use]", into(options.threads, 1, most_threads)},
      {"--isa", "NAME", fmt::format("Instruction set: {} [the widest that can run here]", fmt::join(isa_names, ", ")),
       [&options](std::string_view name) { return take_isa(options, name); }}};
}

const Kernel* kernel_of(const MachineOptions& options) {
  if (options.kernel) return options.kernel;
  if (!usable_kernels().empty()) return usable_kernels().back();
  complain("this machine has none of the instruction sets that this program was built for");
  return nullptr;
}

int threads_of(const MachineOptions& options) { return options.threads > 0 ? options.threads : default_thread_count(); }

}  // namespace penumbra
