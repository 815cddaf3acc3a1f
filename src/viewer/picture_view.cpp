#include "viewer/picture_view.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace penumbra {
// Whole numbers and their inverses, so that every pixel is a square of the same size.
constexpr double zooms[] = {1.0 / 16, 1.0 / 12, 1.0 / 8, 1.0 / 6, 1.0 / 4, 1.0 / 3, 1.0 / 2, 1,  2, 3,
                            4,        6,        8,       12,      16,      24,      32,      48, 64};
constexpr double largest_fit = 4;

void PictureView::set_area(const WindowArea& area) {
  area_ = area;
  if (!moved_) fit();
}

void PictureView::set_picture_size(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  fit();
}

void PictureView::fit() {
  moved_ = false;
  zoom_ = zooms[0];
  for (const double zoom : zooms) {
    if (zoom <= largest_fit && width_ * zoom <= area_.width && height_ * zoom <= area_.height) zoom_ = zoom;
  }
  x_ = area_.x + std::floor((area_.width - width_ * zoom_) / 2);
  y_ = area_.y + std::floor((area_.height - height_ * zoom_) / 2);
}

void PictureView::pan(double dx, double dy) {
  x_ += dx;
  y_ += dy;
  moved_ = true;
}

void PictureView::zoom(int steps, PlaceInWindow place) {
  const auto* now = std::lower_bound(std::begin(zooms), std::end(zooms), zoom_);
  const auto last = static_cast<std::ptrdiff_t>(std::size(zooms)) - 1;
  const double next = zooms[std::clamp<std::ptrdiff_t>((now - zooms) + steps, 0, last)];
  x_ = place.x - (place.x - x_) * (next / zoom_);
  y_ = place.y - (place.y - y_) * (next / zoom_);
  zoom_ = next;
  moved_ = true;
}

WindowArea PictureView::picture() const {
  return {static_cast<int>(std::floor(x_)), static_cast<int>(std::floor(y_)),
          static_cast<int>(std::ceil(width_ * zoom_)), static_cast<int>(std::ceil(height_ * zoom_))};
}

std::optional<PictureView::Pixel> PictureView::pixel_at(PlaceInWindow place) const {
  const double x = std::floor((place.x - std::floor(x_)) / zoom_);
  const double y = std::floor((place.y - std::floor(y_)) / zoom_);
  if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return std::nullopt;
  return Pixel{static_cast<int>(x), static_cast<int>(y)};
}

PlaceInWindow PictureView::in_window(double x, double y) const {
  return {std::floor(x_) + x * zoom_, std::floor(y_) + y * zoom_};
}

}  // namespace penumbra
