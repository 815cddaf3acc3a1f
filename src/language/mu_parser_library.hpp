// muParser's functions, loaded when the first expression needs them: a scene without one starts sooner.
#pragma once

#include <muParserDLL.h>

namespace penumbra {

// The functions that expressions need: applies the macro `use` to each name.
#define PENUMBRA_MU_PARSER_FUNCTIONS(use)                                                                            \
  use(mupCreate) use(mupRelease) use(mupClearFun) use(mupClearConst) use(mupDefineFun1) use(mupDefineFun2)           \
      use(mupDefineMultFun) use(mupDefineConst) use(mupSetExpr) use(mupEvalMulti) use(mupError) use(mupGetErrorCode) \
          use(mupGetErrorPos) use(mupGetErrorToken)

struct MuParserLibrary {
#define PENUMBRA_MEMBER(name) decltype(&::name) name;  // NOLINT(bugprone-macro-parentheses): the name of a member
  PENUMBRA_MU_PARSER_FUNCTIONS(PENUMBRA_MEMBER)
#undef PENUMBRA_MEMBER
};

// The library, which stays loaded. Throws std::runtime_error if it is not installed.
const MuParserLibrary& mu_parser_library();

}  // namespace penumbra
