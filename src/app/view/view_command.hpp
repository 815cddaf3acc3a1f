// `penumbra view`: hands over to the window's program, which is installed next to this one, so that no other subcommand
// loads window libraries.
#pragma once

#include <string>
#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra {

// The name of the window's program.
inline constexpr const char* window_program = "penumbra-view";

// The subcommand `view`. The window's program handles its options and help.
Subcommand view_subcommand();

// Replaces this process by the window's program with these arguments; returns an exit code only if that fails.
int view_command(const std::vector<std::string>& arguments);

}  // namespace penumbra
