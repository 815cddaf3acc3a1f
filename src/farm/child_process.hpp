// Other programs, run to their end.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

struct ChildResult {
  int exit_code = 127;  // 127 where there is no such program; 128 and the signal where one ended it
  std::string output, errors;
};

// Runs a program, found in PATH, with these arguments; no shell comes in between. It is ended after so many seconds.
ChildResult run_child(const std::vector<std::string>& words, double time_limit);

// The same with the terminal, or whatever this program writes to, left to it. Returns the exit code.
int run_child_in_sight(const std::vector<std::string>& words);

}  // namespace penumbra
