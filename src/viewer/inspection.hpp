// What one pixel saw: the values of its samples so far, where they lie, and the rays of one of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rendering/ray_tree.hpp"
#include "viewer/refiner.hpp"

namespace penumbra {

struct InspectedSample {
  int side = 0, x = 0, y = 0;
  std::uint32_t sample = 0;

  bool operator==(const InspectedSample&) const = default;
};

// Where a sample lies in one of the pixel's point sets.
struct SampleDot {
  double u = 0, v = 0;
  std::uint32_t sample = 0;
  float color[3] = {0, 0, 0};  // of the whole sample
};

struct DotPlot {
  std::string name;
  double low = 0;  // both u and v run from here to 1
  std::vector<SampleDot> dots;
};

struct Inspection {
  InspectedSample at;
  std::array<float, 3> so_far{};  // the pixel's value: the mean of all its samples
  RayTree tree;
  std::string text;
  std::string command;         // the call of `penumbra render` that prints the same text
  std::vector<DotPlot> plots;  // in the pixel, on the lens, in time, on each light with an area
  std::uint32_t shown = 0;     // how many samples, from the first on, are in the plots
};

// At most this many samples are plotted.
inline constexpr std::uint32_t most_plotted_samples = 256;

// The sample and the pixel must be in the picture.
Inspection inspect(const Refinement& picture, const Kernel& kernel, const InspectedSample& at);

}  // namespace penumbra
