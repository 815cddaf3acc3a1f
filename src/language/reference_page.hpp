// The reference page of the language, docs/language.md: prose, and tables from the command table.
#pragma once

#include <string>

namespace penumbra {

// The whole page in Markdown.
std::string language_markdown();

}  // namespace penumbra
