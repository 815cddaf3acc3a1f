// Parses options as they come from a command line.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "app/options/command_line.hpp"

namespace penumbra::test {

struct WrongUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The options of the command that `make` describes, as `penumbra ARGUMENTS` sets them; the first argument names the
// command. Throws WrongUse with the error message for wrong arguments.
template <class Options>
Options parse_command(Subcommand (*make)(Options&), const std::vector<std::string>& arguments) {
  Options options;
  const Subcommand command = make(options);
  const std::string wrong = read_words(command, {arguments.begin() + 1, arguments.end()});
  if (!wrong.empty()) throw WrongUse(wrong);
  return options;
}

// The command, its fixed arguments, and those of a test.
inline std::vector<std::string> command_line(std::vector<std::string> fixed, const std::vector<std::string>& more) {
  fixed.insert(fixed.end(), more.begin(), more.end());
  return fixed;
}

}  // namespace penumbra::test
