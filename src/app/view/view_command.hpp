// `penumbra view`: hands over to the program of the window, which lies beside this one, so that no other subcommand
// loads a library of windows.
#pragma once

#include <string>
#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra {

// The name of the window's program.
inline constexpr const char* window_program = "penumbra-view";

// The subcommand `view`. Its options and their help are the business of the window's own program.
Subcommand view_subcommand();

// Becomes the window's program with these arguments; returns an exit code if that is not possible.
int view_command(const std::vector<std::string>& arguments);

}  // namespace penumbra
