// Reads the sums of pixels of a film, and saves them so that added samples can be undone.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "rendering/noise_estimate.hpp"
#include "rendering/pixel_list.hpp"
#include "tracing/film_view.hpp"

namespace penumbra {

inline ColorSum color_sum(const FilmView& film, Pixel pixel) {
  const double* sum = film.color().of_pixel(film.pixels.index_of(pixel));
  return {sum[0], sum[1], sum[2]};
}

class SavedSums {
 public:
  SavedSums(const FilmView& film, std::span<const Pixel> pixels) {
    double* next = values_.data();
    for_sums(film, pixels, [&next](const double* sums, int count) { next = std::copy_n(sums, count, next); });
  }

  void put_back(const FilmView& film, std::span<const Pixel> pixels) const {
    const double* next = values_.data();
    for_sums(film, pixels, [&next](double* sums, int count) {
      std::copy_n(next, count, sums);
      next += count;
    });
  }

 private:
  template <class Visit>
  static void for_sums(const FilmView& film, std::span<const Pixel> pixels, const Visit& visit) {
    for (const Pixel pixel : pixels) {
      for (const FilmPlane& plane : film.all()) {
        visit(plane.of_pixel(film.pixels.index_of(pixel)), plane.sums_per_pixel);
      }
    }
  }

  std::array<double, most_sums * PixelList::capacity> values_;
};

}  // namespace penumbra
