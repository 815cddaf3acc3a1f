// The sums of all samples so far, for every pixel of a crop. Sums are exact (tracing/kernel.hpp), so that a film does
// not tell in which order, by how many threads or in how many sittings its samples came.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rendering/plan.hpp"
#include "tracing/kernel.hpp"

namespace penumbra {

// Whether all pixels have the same number of samples, or each has its own.
enum class SampleCounts { uniform, per_pixel };

class Film {
 public:
  Film(const Crop& crop, const Layers& layers, SampleCounts counts = SampleCounts::uniform);

  const Crop& crop() const { return crop_; }
  const Layers& layers() const { return layers_; }

  // Samples of every pixel, where all have the same number.
  std::uint32_t samples() const { return samples_; }
  void add_samples(std::uint32_t count) { samples_ += count; }
  std::uint64_t total_samples() const;  // of all pixels together

  // Where pixels have counts of their own, whoever renders also says the variance of a pixel's mean, if there is such a
  // layer: the squares of the samples do not tell it.
  bool has_pixel_counts() const { return !pixel_samples_.empty(); }
  void set_samples(int x, int y, std::uint32_t count);
  void set_variance(int x, int y, const std::array<float, 3>& rgb);

  // Where a kernel adds.
  FilmView view();

  // The pixels of `crop`, which lies inside this film's.
  Film cut(const Crop& crop) const;

  // Means over the samples so far, row by row from the top left of the crop; 0 where there are none.
  std::vector<float> color() const;          // r, g, b
  std::vector<float> depth() const;          // along the view; infinity where nothing was hit
  std::vector<float> normal() const;         // x, y, z
  std::vector<float> albedo() const;         // r, g, b
  std::vector<float> variance() const;       // estimated variance of the pixel's mean: r, g, b; 0 below two samples
  std::vector<float> pixel_samples() const;  // how many each pixel has

 private:
  std::size_t pixel_count() const;
  std::size_t pixel_at(int x, int y) const;
  std::uint32_t samples_of(std::size_t pixel) const { return has_pixel_counts() ? pixel_samples_[pixel] : samples_; }
  std::vector<float> means(const std::vector<double>& sums) const;

  Crop crop_;
  Layers layers_;
  std::uint32_t samples_ = 0;
  std::vector<double> color_, squares_, depth_, normal_, albedo_;
  std::vector<std::uint32_t> pixel_samples_;
  std::vector<float> variance_;
};

}  // namespace penumbra
