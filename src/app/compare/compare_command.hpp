// `penumbra compare A B`: measures the difference between two pictures and prints a table or JSON, with the exit codes
// of OpenImageIO's idiff: 0 same, 1 warning, 2 failed, 3 different sizes, 4 no such file (or unreadable).
#pragma once

#include <string>

#include "app/options/command_line.hpp"
#include "image/comparison.hpp"

namespace penumbra {

struct CompareOptions {
  std::string a, b;
  Thresholds thresholds;
  std::string heatmap;  // the file to write; empty for none
  bool json = false;
};

// The subcommand `compare`; its options write to `options`, which must outlive it.
Subcommand compare_subcommand(CompareOptions& options);

// Prints the comparison to standard output, errors to standard error. Returns the exit code, which is 64 if the heat
// map is one of the pictures, 73 or 74 if it cannot be written.
int compare_command(const CompareOptions& options);

}  // namespace penumbra
