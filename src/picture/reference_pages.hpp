// The reference pages docs/language.md and docs/options.md: templates with prose, and tables from those of the commands
// and of the options.
#pragma once

#include <filesystem>
#include <string>

namespace penumbra {

// The whole pages in Markdown, from the templates in docs/templates/. Throw FileError if there is no such template,
// std::out_of_range if it has no place for a table.
std::string language_markdown(const std::filesystem::path& page_template);
std::string options_markdown(const std::filesystem::path& page_template);

}  // namespace penumbra
