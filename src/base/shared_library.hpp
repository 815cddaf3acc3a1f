// A shared library that is loaded when it is first needed: linking to a large one costs every start of the program
// milliseconds, even where it is not used.
#pragma once

#include <string>

namespace penumbra {

class SharedLibrary {
 public:
  // Loads the file, which stays loaded until the program ends. Throws std::runtime_error with the loader's reason and
  // `advice`.
  SharedLibrary(const std::string& file, const std::string& advice);

  // Sets `function` to the function of this name. Throws std::runtime_error if there is none.
  template <typename Function>
  void load(const char* name, Function*& function) const {
    function = reinterpret_cast<Function*>(find(name));
  }

 private:
  void* find(const char* name) const;

  std::string file_;
  void* handle_;
};

}  // namespace penumbra
