// `penumbra view`: hands over to the window's program, which is installed next to this one, so that no other subcommand
// loads window libraries.
#pragma once

#include "app/options/command_line.hpp"

namespace penumbra {

// The subcommand `view`, which replaces this process by the window's program; that handles the options and the help.
Subcommand view_subcommand();

}  // namespace penumbra
