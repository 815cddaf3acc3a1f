// The reference page of the options that change a picture, generated from the table.
#pragma once

#include <string>

namespace penumbra {

// The whole of docs/options.md.
std::string options_markdown();

}  // namespace penumbra
