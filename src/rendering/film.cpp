#include "rendering/film.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace penumbra {

template <class Self, class Visit>
void Film::for_rows(Self& self, const PixelRect& part, const Visit& visit) {
  const auto visit_rows = [&](auto& plane) {
    const std::size_t per_pixel = plane.size() / self.crop_.pixel_count();
    for (int y = part.y0; y < part.y1; y++) {
      const std::size_t first = self.crop_.index_of(part.x0, y);
      visit(std::span(plane).subspan(per_pixel * first, per_pixel * static_cast<std::size_t>(part.width())));
    }
  };
  for (auto& plane : self.sums_) visit_rows(plane);
  visit_rows(self.pixel_samples_);
}

Film::Film(const PixelRect& crop, const Layers& layers, SampleCounts counts)
    : crop_(crop), layers_(layers), counts_(counts), pixel_samples_(crop.pixel_count()) {
  for (const LayerRow& row : layer_table) {
    const auto sums = static_cast<std::size_t>(row.sums());
    if (layers.has(row.layer)) sums_[index_of(row.layer)].resize(sums * crop.pixel_count());
  }
}

std::uint32_t Film::samples() const { return *std::min_element(pixel_samples_.begin(), pixel_samples_.end()); }

std::uint64_t Film::total_samples() const {
  return std::accumulate(pixel_samples_.begin(), pixel_samples_.end(), std::uint64_t{0});
}

void Film::set_samples(std::span<const Pixel> pixels, std::uint32_t count) {
  for (const Pixel pixel : pixels) pixel_samples_[crop_.index_of(pixel)] = count;
}

void Film::set_variance(int x, int y, const std::array<float, 3>& rgb) {
  auto& plane = sums_[index_of(Layer::variance)];
  if (!plane.empty()) std::copy_n(rgb.data(), 3, &plane[3 * crop_.index_of(x, y)]);
}

FilmView Film::view() {
  FilmView view;
  view.pixels = crop_;
  for (const LayerRow& row : layer_table) {
    // If each pixel has its own number of samples, their squares do not give the variance.
    if (row.layer == Layer::variance && counts_ == SampleCounts::per_pixel) continue;
    ZeroedVector<double>& plane = sums_[index_of(row.layer)];
    if (!plane.empty()) view.add({row.layer, row.sums(), plane.data()});
  }
  return view;
}

Film Film::cut(const PixelRect& crop) const {
  Film part(crop, layers_, counts_);
  const auto copy = [&](const auto& whole, auto& piece) {
    const std::size_t per_pixel = piece.size() / crop.pixel_count();
    for (int y = crop.y0; y < crop.y1; y++) {
      const auto from = whole.begin() + static_cast<std::ptrdiff_t>(per_pixel * crop_.index_of(crop.x0, y));
      const auto to = piece.begin() + static_cast<std::ptrdiff_t>(per_pixel * crop.index_of(crop.x0, y));
      std::copy_n(from, per_pixel * static_cast<std::size_t>(crop.width()), to);
    }
  };
  for (std::size_t i = 0; i < layer_count; i++) copy(sums_[i], part.sums_[i]);
  copy(pixel_samples_, part.pixel_samples_);
  return part;
}

void Film::write(ArchiveWriter& archive, const PixelRect& part) const {
  for_rows(*this, part, [&archive](auto row) { archive.numbers(row); });
}

void Film::read(ArchiveReader& archive, const PixelRect& part) {
  for_rows(*this, part, [&archive](auto row) { archive.numbers(row); });
}

void Film::clear(const PixelRect& part) {
  for_rows(*this, part, [](auto row) { std::fill(row.begin(), row.end(), 0); });
}

std::size_t Film::bytes_per_pixel(const Layers& layers) {
  std::size_t bytes = sizeof(std::uint32_t);
  for (const LayerRow& row : layer_table) {
    if (layers.has(row.layer)) bytes += static_cast<std::size_t>(row.sums()) * sizeof(double);
  }
  return bytes;
}

ZeroedVector<float> Film::layer(Layer layer) const {
  ZeroedVector<float> values(row_of(layer).channels.size() * pixel_samples_.size());
  put_values(layer, 0, pixel_samples_.size(), values);
  return values;
}

ZeroedVector<float> Film::take(Layer layer) {
  // So many numbers of 4 bytes and more fill whole huge pages.
  constexpr std::size_t pixels_at_once = ZeroedPages<float>::large_page / sizeof(float);
  const std::size_t pixels = pixel_samples_.size();
  const auto sums_of_pixel = static_cast<std::size_t>(row_of(layer).sums());
  ZeroedVector<double>& sums = sums_[index_of(layer)];
  ZeroedVector<float> values(row_of(layer).channels.size() * pixels);
  for (std::size_t first = 0; first < pixels; first += pixels_at_once) {
    const std::size_t end = std::min(first + pixels_at_once, pixels);
    put_values(layer, first, end, values);
    give_back(sums, sums_of_pixel * first, sums_of_pixel * end);
  }
  ZeroedVector<double>().swap(sums);  // assigning an empty list would keep the memory
  return values;
}

void Film::put_values(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const {
  switch (row_of(layer).value) {
    case LayerValue::mean:
      return put_means(layer, first, end, values);
    case LayerValue::mean_of_hits:
      return put_means_of_hits(layer, first, end, values);
    case LayerValue::variance_of_mean:
      return put_variances(first, end, values);
    case LayerValue::sample_count:
      break;
  }
  for (std::size_t pixel = first; pixel < end; pixel++) values[pixel] = static_cast<float>(pixel_samples_[pixel]);
}

void Film::put_means(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const {
  const ZeroedVector<double>& sums = sums_of(layer);
  const std::size_t channels = row_of(layer).channels.size();
  const auto counts = std::span(pixel_samples_).subspan(first, end - first);
  const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
  if (*fewest == *most) {  // several times faster
    const double samples = std::max(*fewest, 1u);
    for (std::size_t i = channels * first; i < channels * end; i++) values[i] = static_cast<float>(sums[i] / samples);
    return;
  }
  for (std::size_t i = channels * first; i < channels * end; i++) {
    values[i] = static_cast<float>(sums[i] / std::max(pixel_samples_[i / channels], 1u));
  }
}

void Film::put_means_of_hits(Layer layer, std::size_t first, std::size_t end, ZeroedVector<float>& values) const {
  const ZeroedVector<double>& sums = sums_of(layer);
  const std::size_t channels = row_of(layer).channels.size();
  for (std::size_t pixel = first; pixel < end; pixel++) {
    const double* const of_pixel = &sums[pixel * (channels + 1)];
    const double hits = of_pixel[channels];
    for (std::size_t c = 0; c < channels; c++) {
      values[pixel * channels + c] =
          hits > 0 ? static_cast<float>(of_pixel[c] / hits) : std::numeric_limits<float>::infinity();
    }
  }
}

void Film::put_variances(std::size_t first, std::size_t end, ZeroedVector<float>& values) const {
  const ZeroedVector<double>&colors = sums_of(Layer::color), &squares = sums_of(Layer::variance);
  for (std::size_t i = 3 * first; i < 3 * end; i++) {
    if (counts_ == SampleCounts::per_pixel) {
      values[i] = static_cast<float>(squares[i]);
      continue;
    }
    const double n = pixel_samples_[i / 3];
    if (n < 2) continue;
    const double of_samples = std::max(squares[i] - colors[i] * colors[i] / n, 0.0) / (n - 1);
    values[i] = static_cast<float>(of_samples / n);
  }
}

}  // namespace penumbra
