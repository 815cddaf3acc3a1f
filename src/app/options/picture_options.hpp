// The options that change a picture, for every subcommand that makes one: the rows of picture/option_table.hpp.
#pragma once

#include <string_view>
#include <vector>

#include "app/options/command_line.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

// Those that the window knows too, and all of them.
std::vector<CommandOption> view_picture_options(PictureOptions& options);
std::vector<CommandOption> render_picture_options(PictureOptions& options);

// One of them, by its name without dashes.
CommandOption picture_option(PictureOptions& options, std::string_view name);

}  // namespace penumbra
