// The reference page of the language, docs/language.md: a template with prose, and tables from the command table.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace penumbra {

// The text of a template with each `{{name}}` replaced by the text of that name. Throws FileError if there is no such
// template, std::out_of_range if it has no place for a name.
std::string filled_page(const std::filesystem::path& page_template,
                        const std::vector<std::pair<std::string, std::string>>& parts);

// The whole page in Markdown, from docs/templates/language.md.
std::string language_markdown(const std::filesystem::path& page_template);

}  // namespace penumbra
