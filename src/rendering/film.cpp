#include "rendering/film.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace penumbra {
namespace {

// The window `part` of values that stand row by row over the window `whole`.
template <class T>
std::vector<T> cut_plane(const std::vector<T>& values, std::size_t channels, const Crop& whole, const Crop& part) {
  if (values.empty()) return {};
  std::vector<T> result;
  const std::size_t length = channels * static_cast<std::size_t>(part.width());
  result.reserve(length * static_cast<std::size_t>(part.height()));
  for (int y = part.y0; y < part.y1; y++) {
    const std::size_t pixel = static_cast<std::size_t>(y - whole.y0) * static_cast<std::size_t>(whole.width()) +
                              static_cast<std::size_t>(part.x0 - whole.x0);
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(channels * pixel);
    result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(length));
  }
  return result;
}

}  // namespace

Film::Film(const Crop& crop, const Layers& layers, SampleCounts counts) : crop_(crop), layers_(layers) {
  const std::size_t pixels = pixel_count();
  const bool own_counts = counts == SampleCounts::per_pixel;
  color_.resize(3 * pixels);
  if (layers.variance && !own_counts) squares_.resize(3 * pixels);
  if (layers.variance && own_counts) variance_.resize(3 * pixels);
  if (layers.depth) depth_.resize(2 * pixels);
  if (layers.normal) normal_.resize(3 * pixels);
  if (layers.albedo) albedo_.resize(3 * pixels);
  if (own_counts) pixel_samples_.resize(pixels);
}

std::size_t Film::pixel_count() const {
  return static_cast<std::size_t>(crop_.width()) * static_cast<std::size_t>(crop_.height());
}

std::size_t Film::pixel_at(int x, int y) const {
  return static_cast<std::size_t>(y - crop_.y0) * static_cast<std::size_t>(crop_.width()) +
         static_cast<std::size_t>(x - crop_.x0);
}

std::uint64_t Film::total_samples() const {
  if (!has_pixel_counts()) return samples_ * std::uint64_t{pixel_count()};
  return std::accumulate(pixel_samples_.begin(), pixel_samples_.end(), std::uint64_t{0});
}

void Film::set_samples(int x, int y, std::uint32_t count) { pixel_samples_[pixel_at(x, y)] = count; }

void Film::set_variance(int x, int y, const std::array<float, 3>& rgb) {
  if (!variance_.empty()) std::copy_n(rgb.data(), 3, &variance_[3 * pixel_at(x, y)]);
}

FilmView Film::view() {
  const auto plane = [](std::vector<double>& v) { return v.empty() ? nullptr : v.data(); };
  return {plane(color_),  plane(squares_), plane(depth_), plane(normal_),
          plane(albedo_), crop_.x0,        crop_.y0,      crop_.width()};
}

Film Film::cut(const Crop& crop) const {
  Film part(crop, layers_, has_pixel_counts() ? SampleCounts::per_pixel : SampleCounts::uniform);
  part.samples_ = samples_;
  part.color_ = cut_plane(color_, 3, crop_, crop);
  part.squares_ = cut_plane(squares_, 3, crop_, crop);
  part.depth_ = cut_plane(depth_, 2, crop_, crop);
  part.normal_ = cut_plane(normal_, 3, crop_, crop);
  part.albedo_ = cut_plane(albedo_, 3, crop_, crop);
  part.pixel_samples_ = cut_plane(pixel_samples_, 1, crop_, crop);
  part.variance_ = cut_plane(variance_, 3, crop_, crop);
  return part;
}

std::vector<float> Film::means(const std::vector<double>& sums) const {
  std::vector<float> result(sums.size());
  if (has_pixel_counts()) {
    for (std::size_t i = 0; i < sums.size(); i++) {
      result[i] = static_cast<float>(sums[i] / std::max(samples_of(i / 3), 1u));
    }
    return result;
  }
  const double samples = std::max(samples_, 1u);
  for (std::size_t i = 0; i < sums.size(); i++) result[i] = static_cast<float>(sums[i] / samples);
  return result;
}

std::vector<float> Film::color() const { return means(color_); }
std::vector<float> Film::normal() const { return means(normal_); }
std::vector<float> Film::albedo() const { return means(albedo_); }

std::vector<float> Film::depth() const {
  std::vector<float> result(depth_.size() / 2);
  for (std::size_t i = 0; i < result.size(); i++) {
    const double hits = depth_[2 * i + 1];
    result[i] = hits > 0 ? static_cast<float>(depth_[2 * i] / hits) : std::numeric_limits<float>::infinity();
  }
  return result;
}

std::vector<float> Film::variance() const {
  if (has_pixel_counts()) return variance_;
  std::vector<float> result(squares_.size());
  if (samples_ < 2) return result;
  const double n = samples_;
  for (std::size_t i = 0; i < result.size(); i++) {
    const double of_samples = std::max(squares_[i] - color_[i] * color_[i] / n, 0.0) / (n - 1);
    result[i] = static_cast<float>(of_samples / n);
  }
  return result;
}

std::vector<float> Film::pixel_samples() const {
  std::vector<float> result(pixel_count());
  for (std::size_t i = 0; i < result.size(); i++) result[i] = static_cast<float>(samples_of(i));
  return result;
}

}  // namespace penumbra
