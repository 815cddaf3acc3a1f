// Options of how to render, not what: they never change a picture.
#pragma once

#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra {

struct Kernel;

struct MachineOptions {
  int threads = 0;                 // 0: all processors this process may use
  const Kernel* kernel = nullptr;  // null: the widest that can run here
};

// --threads and --isa.
std::vector<CommandOption> machine_options(MachineOptions& options);

// The kernel and the number of threads, with defaults filled in. If this machine can run no instruction set of the
// program, the kernel is null and an error is printed.
const Kernel* kernel_of(const MachineOptions& options);
int threads_of(const MachineOptions& options);

}  // namespace penumbra
