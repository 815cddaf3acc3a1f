#include "rendering/film.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace penumbra {
namespace {

// Calls `visit(values)` for each row of the pixels `part` in a plane that stands row by row over the window `whole`.
template <class Plane, class Visit>
void for_rows(Plane& plane, const Crop& whole, const Crop& part, const Visit& visit) {
  const std::size_t pixels = static_cast<std::size_t>(whole.width()) * static_cast<std::size_t>(whole.height());
  const std::size_t channels = plane.size() / pixels;
  for (int y = part.y0; y < part.y1; y++) {
    const std::size_t pixel = static_cast<std::size_t>(y - whole.y0) * static_cast<std::size_t>(whole.width()) +
                              static_cast<std::size_t>(part.x0 - whole.x0);
    visit(std::span(plane).subspan(channels * pixel, channels * static_cast<std::size_t>(part.width())));
  }
}

}  // namespace

template <class Self, class Visit>
void Film::for_planes(Self& self, const Visit& visit) {
  visit(self.color_);
  visit(self.squares_);
  visit(self.depth_);
  visit(self.normal_);
  visit(self.albedo_);
  visit(self.pixel_samples_);
  visit(self.variance_);
}

Film::Film(const Crop& crop, const Layers& layers, SampleCounts counts)
    : crop_(crop), layers_(layers), counts_(counts) {
  const std::size_t pixels = pixel_count();
  const bool own_counts = counts == SampleCounts::per_pixel;
  color_.resize(3 * pixels);
  if (layers.variance && !own_counts) squares_.resize(3 * pixels);
  if (layers.variance && own_counts) variance_.resize(3 * pixels);
  if (layers.depth) depth_.resize(2 * pixels);
  if (layers.normal) normal_.resize(3 * pixels);
  if (layers.albedo) albedo_.resize(3 * pixels);
  pixel_samples_.resize(pixels);
}

std::size_t Film::pixel_count() const {
  return static_cast<std::size_t>(crop_.width()) * static_cast<std::size_t>(crop_.height());
}

std::size_t Film::pixel_at(int x, int y) const {
  return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.width()) +
         static_cast<std::size_t>(x - crop_.x0);
}

std::uint32_t Film::samples() const { return *std::min_element(pixel_samples_.begin(), pixel_samples_.end()); }

std::uint64_t Film::total_samples() const {
  return std::accumulate(pixel_samples_.begin(), pixel_samples_.end(), std::uint64_t{0});
}

void Film::set_samples(std::span<const PixelPlace> pixels, std::uint32_t count) {
  for (const PixelPlace& p : pixels) pixel_samples_[pixel_at(static_cast<int>(p.x), static_cast<int>(p.y))] = count;
}

void Film::set_variance(int x, int y, const std::array<float, 3>& rgb) {
  if (!variance_.empty()) std::copy_n(rgb.data(), 3, &variance_[3 * pixel_at(x, y)]);
}

FilmView Film::view() {
  const auto plane = [](ZeroedVector<double>& v) { return v.empty() ? nullptr : v.data(); };
  return {plane(color_),  plane(squares_), plane(depth_), plane(normal_),
          plane(albedo_), crop_.x0,        crop_.y0,      crop_.width()};
}

Film Film::cut(const Crop& crop) const {
  Film part(crop, layers_, counts_);
  ArchiveWriter writer;
  write(writer, crop);
  ArchiveReader reader(writer.bytes());
  part.read(reader, crop);
  return part;
}

void Film::write(ArchiveWriter& archive, const Crop& part) const {
  for_planes(*this,
             [&](const auto& plane) { for_rows(plane, crop_, part, [&archive](auto row) { archive.numbers(row); }); });
}

void Film::read(ArchiveReader& archive, const Crop& part) {
  for_planes(*this, [&](auto& plane) { for_rows(plane, crop_, part, [&archive](auto row) { archive.numbers(row); }); });
}

void Film::clear(const Crop& part) {
  for_planes(*this, [&](auto& plane) {
    for_rows(plane, crop_, part, [](auto row) { std::fill(row.begin(), row.end(), 0); });
  });
}

std::size_t Film::bytes_per_pixel(const Layers& layers, SampleCounts counts) {
  const bool own_counts = counts == SampleCounts::per_pixel;
  const int sums = 3 + (layers.variance && !own_counts ? 3 : 0) + (layers.depth ? 2 : 0) + (layers.normal ? 3 : 0) +
                   (layers.albedo ? 3 : 0);
  return static_cast<std::size_t>(sums) * sizeof(double) + sizeof(std::uint32_t) +
         (layers.variance && own_counts ? 3 * sizeof(float) : 0);
}

ZeroedVector<float> Film::means(const ZeroedVector<double>& sums) const {
  ZeroedVector<float> result(sums.size());
  const auto [fewest, most] = std::minmax_element(pixel_samples_.begin(), pixel_samples_.end());
  if (*fewest == *most) {  // which is several times faster
    const double samples = std::max(*fewest, 1u);
    for (std::size_t i = 0; i < sums.size(); i++) result[i] = static_cast<float>(sums[i] / samples);
    return result;
  }
  for (std::size_t i = 0; i < sums.size(); i++) {
    result[i] = static_cast<float>(sums[i] / std::max(pixel_samples_[i / 3], 1u));
  }
  return result;
}

ZeroedVector<float> Film::color() const { return means(color_); }
ZeroedVector<float> Film::normal() const { return means(normal_); }
ZeroedVector<float> Film::albedo() const { return means(albedo_); }

ZeroedVector<float> Film::depth() const {
  ZeroedVector<float> result(depth_.size() / 2);
  for (std::size_t i = 0; i < result.size(); i++) {
    const double hits = depth_[2 * i + 1];
    result[i] = hits > 0 ? static_cast<float>(depth_[2 * i] / hits) : std::numeric_limits<float>::infinity();
  }
  return result;
}

ZeroedVector<float> Film::variance() const {
  if (counts_ == SampleCounts::per_pixel) return {variance_.begin(), variance_.end()};
  ZeroedVector<float> result(squares_.size());
  for (std::size_t i = 0; i < result.size(); i++) {
    const double n = pixel_samples_[i / 3];
    if (n < 2) continue;
    const double of_samples = std::max(squares_[i] - color_[i] * color_[i] / n, 0.0) / (n - 1);
    result[i] = static_cast<float>(of_samples / n);
  }
  return result;
}

ZeroedVector<float> Film::pixel_samples() const { return {pixel_samples_.begin(), pixel_samples_.end()}; }

}  // namespace penumbra
