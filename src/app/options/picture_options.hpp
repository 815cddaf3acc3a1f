// The options that change a picture, for every subcommand that makes one: the rows of picture/option_table.hpp.
#pragma once

#include <string_view>
#include <vector>

#include "app/options/command_line.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {

// The options that the window has too, and all options.
std::vector<CommandOption> view_picture_options(PictureOptions& options);
std::vector<CommandOption> render_picture_options(PictureOptions& options);

// One option, by its name without dashes.
CommandOption picture_option(PictureOptions& options, std::string_view name);

}  // namespace penumbra
