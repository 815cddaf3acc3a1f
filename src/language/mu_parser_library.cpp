#include "language/mu_parser_library.hpp"

#include "base/shared_library.hpp"

namespace penumbra {
namespace {

MuParserLibrary load() {
  const SharedLibrary file("libmuparser.so.2", "install the Debian package libmuparser2v5");
  MuParserLibrary m;
#define PENUMBRA_LOAD(name) file.load(#name, m.name);
  PENUMBRA_MU_PARSER_FUNCTIONS(PENUMBRA_LOAD)
#undef PENUMBRA_LOAD
  return m;
}

}  // namespace

const MuParserLibrary& mu_parser_library() {
  static const MuParserLibrary library = load();
  return library;
}

}  // namespace penumbra
