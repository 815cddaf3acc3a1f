// Prints the reference page of the options; the target `options_page` writes it to docs/options.md.
#include <cstdio>

#include "picture/option_page.hpp"

int main() {
  const std::string page = penumbra::options_markdown();
  return std::fwrite(page.data(), 1, page.size(), stdout) == page.size() ? 0 : 1;
}
