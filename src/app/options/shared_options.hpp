// Options that several subcommands share: those of what a picture shows and those of how it is made.
#pragma once

#include <string_view>
#include <vector>

#include "app/options/command_line.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

struct Kernel;

// The options that change a picture: the rows of picture/option_table.hpp, all or those that the window has too.
std::vector<CommandOption> picture_options(PictureOptions& options, bool of_window);

// One of them, by its name without dashes.
CommandOption picture_option(PictureOptions& options, std::string_view name);

// --allow-paths, of all commands that read a scene.
CommandOption paths_option(PictureOptions& options);

// Options of how to render, not what: they never change a picture.
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
