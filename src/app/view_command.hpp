// `penumbra view`: hands over to the program of the window, which lies beside this one, so that no other subcommand
// loads a library of windows.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

// The name of the window's program.
inline constexpr const char* window_program = "penumbra-view";

// Becomes the window's program with these arguments; returns an exit code if that is not possible.
int view_command(const std::vector<std::string>& arguments);

}  // namespace penumbra
