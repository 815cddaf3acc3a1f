// muParser's functions, loaded when the first expression needs them: a scene without one starts sooner.
#pragma once

#include <muParserDLL.h>

namespace penumbra {

struct MuParserLibrary {
  decltype(&::mupCreate) mupCreate;
  decltype(&::mupRelease) mupRelease;
  decltype(&::mupClearFun) mupClearFun;
  decltype(&::mupClearConst) mupClearConst;
  decltype(&::mupDefineFun1) mupDefineFun1;
  decltype(&::mupDefineFun2) mupDefineFun2;
  decltype(&::mupDefineMultFun) mupDefineMultFun;
  decltype(&::mupDefineConst) mupDefineConst;
  decltype(&::mupSetExpr) mupSetExpr;
  decltype(&::mupEvalMulti) mupEvalMulti;
  decltype(&::mupError) mupError;
  decltype(&::mupGetErrorCode) mupGetErrorCode;
  decltype(&::mupGetErrorPos) mupGetErrorPos;
  decltype(&::mupGetErrorToken) mupGetErrorToken;
};

// The library, which stays loaded. Throws std::runtime_error if it is not installed.
const MuParserLibrary& mu_parser_library();

}  // namespace penumbra
