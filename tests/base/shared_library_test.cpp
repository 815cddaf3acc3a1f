// Libraries that are loaded when needed: what the error says if one is missing.
#include "base/shared_library.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace penumbra {
namespace {

std::string problem(void (*use)()) {
  try {
    use();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SharedLibrary, FindsFunctions) {
  const SharedLibrary file("libm.so.6", "it is part of libc");
  double (*cosine)(double) = nullptr;
  file.load("cos", cosine);
  EXPECT_EQ(cosine(0), 1);
}

TEST(SharedLibrary, SaysWhatToDoAboutAMissingOne) {
  EXPECT_EQ(problem([] { SharedLibrary("libnowhere.so.1", "install nowhere"); }),
            "cannot load libnowhere.so.1 (libnowhere.so.1: cannot open shared object file: No such file or directory): "
            "install nowhere");
}

TEST(SharedLibrary, NamesAMissingFunction) {
  EXPECT_EQ(problem([] {
              void (*none)() = nullptr;
              SharedLibrary("libm.so.6", "it is part of libc").load("no_such_function", none);
            }),
            "libm.so.6 has no function no_such_function");
}

}  // namespace
}  // namespace penumbra
