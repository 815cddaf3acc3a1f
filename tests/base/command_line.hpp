// Options as they come from a command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace penumbra::test {

// What `penumbra ARGUMENTS` makes of the options of one command, which `add` declares; the first argument names the
// command. Throws what CLI11 throws at wrong use.
template <class Result, class Options>
Options parse_command(Result (*add)(CLI::App&, Options&), const std::vector<std::string>& arguments) {
  CLI::App app;
  Options options;
  add(app, options);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // from the last on, as CLI11 wants them
  return options;
}

// The command, its fixed arguments, and those of a test.
inline std::vector<std::string> command_line(std::vector<std::string> fixed, const std::vector<std::string>& more) {
  fixed.insert(fixed.end(), more.begin(), more.end());
  return fixed;
}

}  // namespace penumbra::test
