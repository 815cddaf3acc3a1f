// Options of how to render and not of what: they never change a picture.
#pragma once

#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra {

struct Kernel;

struct MachineOptions {
  int threads = 0;                 // 0: as many as there are
  const Kernel* kernel = nullptr;  // null: the widest that can run here
};

// --threads and --isa.
std::vector<CommandOption> machine_options(MachineOptions& options);

// With what was left open filled in. Null where no instruction set of the program can run here: then nothing can be
// rendered, and a message says so.
const Kernel* kernel_of(const MachineOptions& options);
int threads_of(const MachineOptions& options);

}  // namespace penumbra
