// Prints the reference page of the language; the target `language_page` writes it to docs/language.md.
#include <cstdio>

#include "language/reference_page.hpp"

int main() {
  const std::string page = penumbra::language_markdown();
  return std::fwrite(page.data(), 1, page.size(), stdout) == page.size() ? 0 : 1;
}
