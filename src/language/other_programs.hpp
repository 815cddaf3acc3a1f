// Commands of other programs that read `.cli` files: coursework of later projects and private additions.
#pragma once

#include <string_view>

namespace penumbra {

// Whether `word` is a command that only other programs know.
bool is_command_of_other_programs(std::string_view word);

}  // namespace penumbra
