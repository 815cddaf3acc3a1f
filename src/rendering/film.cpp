#include "rendering/film.hpp"

#include <algorithm>
#include <limits>

namespace penumbra {

Film::Film(const Crop& crop, const Layers& layers) : crop_(crop), layers_(layers) {
  const std::size_t pixels = static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
  color_.resize(3 * pixels);
  if (layers.variance) squares_.resize(3 * pixels);
  if (layers.depth) depth_.resize(2 * pixels);
  if (layers.normal) normal_.resize(3 * pixels);
  if (layers.albedo) albedo_.resize(3 * pixels);
}

FilmView Film::view() {
  const auto plane = [](std::vector<double>& v) { return v.empty() ? nullptr : v.data(); };
  return {plane(color_),  plane(squares_), plane(depth_), plane(normal_),
          plane(albedo_), crop_.x0,        crop_.y0,      crop_.width()};
}

std::vector<float> Film::means(const std::vector<double>& sums) const {
  std::vector<float> result(sums.size());
  const double count = std::max(samples_, 1u);
  std::transform(sums.begin(), sums.end(), result.begin(), [&](double s) { return static_cast<float>(s / count); });
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
  std::vector<float> result(squares_.size());
  if (samples_ < 2) return result;
  const double n = samples_;
  for (std::size_t i = 0; i < result.size(); i++) {
    const double of_samples = std::max(squares_[i] - color_[i] * color_[i] / n, 0.0) / (n - 1);
    result[i] = static_cast<float>(of_samples / n);
  }
  return result;
}

}  // namespace penumbra
