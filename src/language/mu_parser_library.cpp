#include "language/mu_parser_library.hpp"

#include "base/shared_library.hpp"

namespace penumbra {
namespace {

MuParserLibrary load() {
  const SharedLibrary file("libmuparser.so.2", "install the Debian package libmuparser2v5");
  MuParserLibrary m;
#define PENUMBRA_LOAD(name) file.load(#name, m.name)
  PENUMBRA_LOAD(mupCreate);
  PENUMBRA_LOAD(mupRelease);
  PENUMBRA_LOAD(mupClearFun);
  PENUMBRA_LOAD(mupClearConst);
  PENUMBRA_LOAD(mupDefineFun1);
  PENUMBRA_LOAD(mupDefineFun2);
  PENUMBRA_LOAD(mupDefineMultFun);
  PENUMBRA_LOAD(mupDefineConst);
  PENUMBRA_LOAD(mupSetExpr);
  PENUMBRA_LOAD(mupEvalMulti);
  PENUMBRA_LOAD(mupError);
  PENUMBRA_LOAD(mupGetErrorCode);
  PENUMBRA_LOAD(mupGetErrorPos);
  PENUMBRA_LOAD(mupGetErrorToken);
#undef PENUMBRA_LOAD
  return m;
}

}  // namespace

const MuParserLibrary& mu_parser_library() {
  static const MuParserLibrary library = load();
  return library;
}

}  // namespace penumbra
