// The sums of all samples so far, for every pixel of a crop. Sums are exact (tracing/kernel.hpp), so that a film does
// not tell in which order, by how many threads or in how many sittings its samples came.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rendering/plan.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

class Film {
 public:
  Film(const Crop& crop, const Layers& layers);

  const Crop& crop() const { return crop_; }
  const Layers& layers() const { return layers_; }
  std::uint32_t samples() const { return samples_; }
  void add_samples(std::uint32_t count) { samples_ += count; }

  // Where a kernel adds.
  FilmView view();

  // Means over the samples so far, row by row from the top left of the crop; 0 where there are none.
  std::vector<float> color() const;     // r, g, b
  std::vector<float> depth() const;     // along the view; infinity where nothing was hit
  std::vector<float> normal() const;    // x, y, z
  std::vector<float> albedo() const;    // r, g, b
  std::vector<float> variance() const;  // estimated variance of the pixel's mean: r, g, b; 0 below two samples

 private:
  std::vector<float> means(const std::vector<double>& sums) const;

  Crop crop_;
  Layers layers_;
  std::uint32_t samples_ = 0;
  std::vector<double> color_, squares_, depth_, normal_, albedo_;
};

}  // namespace penumbra
