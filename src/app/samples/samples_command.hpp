// `penumbra samples`: plots a sample pattern and prints its figures: discrepancy, distances, cells, and how fast its
// error falls with the number of samples.
#pragma once

#include <cstdint>
#include <string>

#include "app/options/command_line.hpp"
#include "sampling/pattern.hpp"

namespace penumbra {

struct SamplesOptions {
  Pattern sampler = default_pattern;
  int n = 64;
  std::uint32_t seed = 0;
  int pixel_x = 0, pixel_y = 0;
  std::string dimensions = "pixel";  // pixel, lens, light, gloss
  std::string output;                // the plot to write; empty for none
  bool json = false;
};

// The subcommand `samples`; its options write to `options`, which must outlive it.
Subcommand samples_subcommand(SamplesOptions& options);

// Prints figures to standard output, errors to standard error. Returns the exit code, which is 73 or 74 if the plot
// cannot be written.
int samples_command(const SamplesOptions& options);

}  // namespace penumbra
