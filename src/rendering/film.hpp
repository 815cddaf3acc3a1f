// The sums of all samples so far for every pixel of a crop, and their number. Sums are exact (tracing/film_packet.hpp),
// so that a film does not depend on the order of its samples or on the number of threads and sessions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/archive.hpp"
#include "base/zeroed_pages.hpp"
#include "rendering/plan.hpp"
#include "tracing/film_view.hpp"

namespace penumbra {

class Film {
 public:
  Film(const PixelRect& crop, const Layers& layers, SampleCounts counts = SampleCounts::uniform);

  const PixelRect& crop() const { return crop_; }
  const Layers& layers() const { return layers_; }
  SampleCounts counts() const { return counts_; }

  // The number of samples of a pixel. Code that adds samples has to set it.
  std::uint32_t samples_at(int x, int y) const { return pixel_samples_[crop_.index_of(x, y)]; }
  std::uint32_t samples_at(Pixel pixel) const { return pixel_samples_[crop_.index_of(pixel)]; }
  void set_samples(std::span<const Pixel> pixels, std::uint32_t count);
  // For films in which each pixel has its own number of samples; does nothing without the layer.
  void set_variance(int x, int y, const std::array<float, 3>& rgb);

  std::uint32_t samples() const;        // of the pixel that has the fewest
  std::uint64_t total_samples() const;  // of all pixels together

  // The sums that a kernel adds to.
  FilmView view();

  // The pixels of `crop`, which must lie inside this film's.
  Film cut(const PixelRect& crop) const;

  // Everything about the pixels of `part`, which must lie inside the film's crop.
  void write(ArchiveWriter& archive, const PixelRect& part) const;
  void read(ArchiveReader& archive, const PixelRect& part);
  static std::size_t bytes_per_pixel(const Layers& layers);  // that write() writes

  // Removes the samples of these pixels.
  void clear(const PixelRect& part);

  // The values of a layer (tracing/layers.hpp) from each pixel's samples so far, row by row from the top left of the
  // crop. The film must have the layer; every film has the colour and the number of samples.
  ZeroedVector<float> layer(Layer layer) const;
  ZeroedVector<float> color() const { return layer(Layer::color); }

  // The same values, for which the layer is given up: the memory of its sums is freed while they are read, so that both
  // together never take more than the sums alone. Colours must go last: the variance needs them, too.
  ZeroedVector<float> take(Layer layer);

 private:
  const ZeroedVector<double>& sums_of(Layer layer) const { return sums_[index_of(layer)]; }
  // Part of the values of a layer: those of the pixels from `first` to before `end`, to the places of these in
  // `values`.
  void put_values(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const;
  void put_means(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const;
  void put_means_of_hits(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const;
  void put_variances(std::size_t first, std::size_t end, ZeroedVector<float>& values) const;
  // Calls `visit(values)` for each row of the pixels of `part` in each plane of numbers.
  template <class Self, class Visit>
  static void for_rows(Self& self, const PixelRect& part, const Visit& visit);

  PixelRect crop_;
  Layers layers_;
  SampleCounts counts_;
  std::array<ZeroedVector<double>, layer_count> sums_;  // with counts per pixel, variance itself instead of its sums
  ZeroedVector<std::uint32_t> pixel_samples_;
};

}  // namespace penumbra
