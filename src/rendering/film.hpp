// The sums of all samples so far, for every pixel of a crop, and how many these are. Sums are exact
// (tracing/film_view.hpp), so that a film does not tell in which order, by how many threads or in how many sittings its
// samples came.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/zeroed_pages.hpp"
#include "rendering/plan.hpp"
#include "tracing/film_view.hpp"

namespace penumbra {

class Film {
 public:
  Film(const Crop& crop, const Layers& layers, SampleCounts counts = SampleCounts::uniform);

  const Crop& crop() const { return crop_; }
  const Layers& layers() const { return layers_; }

  SampleCounts counts() const { return counts_; }

  // Whoever adds samples says so, pixel by pixel.
  std::uint32_t samples_at(int x, int y) const { return pixel_samples_[pixel_at(x, y)]; }
  void set_samples(std::span<const PixelPlace> pixels, std::uint32_t count);
  void set_variance(int x, int y, const std::array<float, 3>& rgb);

  std::uint32_t samples() const;        // of the pixel that has the fewest
  std::uint64_t total_samples() const;  // of all pixels together

  // Where a kernel adds.
  FilmView view();

  // The pixels of `crop`, which lies inside this film's.
  Film cut(const Crop& crop) const;

  // All that there is of the pixels of `part`, which lies inside the film's crop.
  void write(ArchiveWriter& archive, const Crop& part) const;
  void read(ArchiveReader& archive, const Crop& part);
  static std::size_t bytes_per_pixel(const Layers& layers, SampleCounts counts);  // of that

  // Takes the samples of these pixels out again.
  void clear(const Crop& part);

  // Means over each pixel's samples so far, row by row from the top left of the crop; 0 where there are none.
  ZeroedVector<float> color() const;          // r, g, b
  ZeroedVector<float> depth() const;          // along the view; infinity where nothing was hit
  ZeroedVector<float> normal() const;         // x, y, z
  ZeroedVector<float> albedo() const;         // r, g, b
  ZeroedVector<float> variance() const;       // estimated variance of the pixel's mean: r, g, b; 0 below two samples
  ZeroedVector<float> pixel_samples() const;  // how many each pixel has

  // Frees the sums of a layer, which cannot be asked for after that. Colours go last: the variance needs them too.
  void forget_depth() { free_plane(depth_); }
  void forget_normal() { free_plane(normal_); }
  void forget_albedo() { free_plane(albedo_); }
  void forget_variance() { free_plane(squares_), free_plane(variance_); }

 private:
  std::size_t pixel_count() const;
  std::size_t pixel_at(int x, int y) const;
  ZeroedVector<float> means(const ZeroedVector<double>& sums) const;
  template <class Plane>
  static void free_plane(Plane& plane) {
    Plane().swap(plane);  // the assignment of an empty list would keep the memory
  }
  // Calls `visit(plane)` for each plane of numbers that there is.
  template <class Self, class Visit>
  static void for_planes(Self& self, const Visit& visit);

  Crop crop_;
  Layers layers_;
  SampleCounts counts_;
  ZeroedVector<double> color_, squares_, depth_, normal_, albedo_;
  ZeroedVector<std::uint32_t> pixel_samples_;
  ZeroedVector<float> variance_;
};

}  // namespace penumbra
