// Whether two pictures are the same, by the thresholds and verdicts of OpenImageIO's idiff, and how much they differ.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "image/metrics.hpp"

namespace penumbra {

// A pixel is beyond a threshold when any of its values differs by more, or is not finite in one picture only. The
// thresholds are rounded to float, as the values are, so that 0.1 and 0.2 do not differ by more than 0.1.
struct Thresholds {
  double fail = 1e-6;
  double fail_percent = 0;  // of the pixels that may be beyond `fail`
  double hard_fail = std::numeric_limits<double>::infinity();
  double warn = 1e-6;
  double warn_percent = 0;
  double hard_warn = std::numeric_limits<double>::infinity();
};

// The values are the exit codes.
enum class Verdict { same = 0, warning = 1, failed = 2, different_size = 3, no_such_file = 4 };

std::string to_string(Verdict verdict);

struct LayerComparison {
  std::string name;
  double max_difference = 0;
  std::size_t pixels_beyond = 0;  // `fail`
};

struct Comparison {
  Verdict verdict = Verdict::same;
  int width = 0, height = 0;
  ErrorFigures errors;
  double ssim = 1, flip = 0;
  double max_difference = 0;                       // of the colours
  std::size_t pixels_beyond = 0;                   // `fail`, of the colours
  std::size_t not_finite_a = 0, not_finite_b = 0;  // pixels of each picture with a colour that is not finite
  std::vector<float> pixel_differences;            // of the colours
  std::vector<LayerComparison> layers;             // in both files
  std::vector<std::string> missing_layers;         // in one file only
};

// Whether the pictures have the same size and, where both are crops, show the same window.
bool can_compare(const ImageFile& a, const ImageFile& b);

// Compares pictures for which can_compare() holds. Failed: more than fail_percent of the pixels are beyond `fail`, or
// one is beyond hard_fail; else a warning by the other three; else same. Layers in both files count like colours; a
// layer in one file only is a failure if the other file has any, and is ignored if it has none (a PNG, say).
Comparison compare(const ImageFile& a, const ImageFile& b, const Thresholds& thresholds);

// A false-colour picture of where two pictures differ: from black through violet, red and orange to pale yellow, each
// colour lighter than the one before, so that it also works in grey and for colour-blind viewers.
//
// One pixel per difference: black for 0, pale yellow for `scale` and more, including infinity.
Image heatmap(const std::vector<float>& differences, int width, int height, float scale);

}  // namespace penumbra
