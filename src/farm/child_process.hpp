// Runs other programs to their end.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

struct ChildResult {
  int exit_code = 127;  // 127: no such program; 128 + N: ended by signal N
  std::string output, errors;
};

// Runs a program, found in PATH, with these arguments and without a shell. It is killed after `time_limit` seconds.
ChildResult run_child(const std::vector<std::string>& words, double time_limit);

// The same without a time limit, with this program's input and output. Returns the exit code.
int run_child_in_sight(const std::vector<std::string>& words);

}  // namespace penumbra
