// `penumbra compare A B`: how far two pictures are apart, as a table or as JSON, with the exit codes of OpenImageIO's
// idiff: 0 same, 1 warning, 2 failed, 3 not the same size, 4 no such file (or none that can be read).
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

// The subcommand `compare`; its options fill `options`, which has to outlive it.
Subcommand compare_subcommand(CompareOptions& options);

// Compares and reports to standard output; what is wrong goes to standard error. Returns the exit code, which is 73 or
// 74 when the heat map cannot be written.
int compare_command(const CompareOptions& options);

}  // namespace penumbra
