#include "base/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace penumbra {

SharedLibrary::SharedLibrary(const std::string& file, const std::string& advice)
    : file_(file), handle_(dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL)) {
  if (handle_ == nullptr) throw std::runtime_error(fmt::format("cannot load {} ({}): {}", file, dlerror(), advice));
}

void* SharedLibrary::find(const char* name) const {
  void* const symbol = dlsym(handle_, name);
  if (symbol == nullptr) throw std::runtime_error(fmt::format("{} has no function {}", file_, name));
  return symbol;
}

}  // namespace penumbra
