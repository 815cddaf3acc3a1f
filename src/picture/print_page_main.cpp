// Prints a reference page, `language` or `options`, from its template; the targets `language_page` and `options_page`
// write them to docs/.
#include <fmt/format.h>

#include <string_view>

#include "base/say.hpp"

#include "picture/reference_pages.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 64;
  const bool is_language = std::string_view(argv[1]) == "language";
  penumbra::print(is_language ? penumbra::language_markdown(argv[2]) : penumbra::options_markdown(argv[2]));
}
