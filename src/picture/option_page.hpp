// The reference page of the options that change a picture, made from the table.
#pragma once

#include <string>

namespace penumbra {

// docs/options.md, all of it.
std::string options_markdown();

}  // namespace penumbra
