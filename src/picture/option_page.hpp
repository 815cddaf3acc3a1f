// The reference page of the options that change a picture, generated from the table.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra {

// The whole of docs/options.md, from docs/templates/options.md.
std::string options_markdown(const std::filesystem::path& page_template);

}  // namespace penumbra
