// The sums of pixels of a film, looked at and kept aside while samples are added to them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "rendering/noise_estimate.hpp"
#include "rendering/pixel_list.hpp"
#include "tracing/film_view.hpp"

namespace penumbra {

inline ColorSum color_sum(const FilmView& film, PixelPlace pixel) {
  const double* sum = film.color + 3 * film.index_of(pixel);
  return {sum[0], sum[1], sum[2]};
}

class SavedSums {
 public:
  SavedSums(const FilmView& film, std::span<const PixelPlace> pixels) {
    double* next = values_.data();
    for_planes(film, pixels,
               [&next](const double* sums, std::size_t channels) { next = std::copy_n(sums, channels, next); });
  }

  void put_back(const FilmView& film, std::span<const PixelPlace> pixels) const {
    const double* next = values_.data();
    for_planes(film, pixels, [&next](double* sums, std::size_t channels) {
      std::copy_n(next, channels, sums);
      next += channels;
    });
  }

 private:
  template <class Visit>
  static void for_planes(const FilmView& film, std::span<const PixelPlace> pixels, const Visit& visit) {
    for (const PixelPlace& place : pixels) {
      const std::size_t pixel = film.index_of(place);
      const auto plane = [&](double* sums, std::size_t channels) {
        if (sums) visit(sums + channels * pixel, channels);
      };
      plane(film.color, 3);
      plane(film.squares, 3);
      plane(film.depth, 2);
      plane(film.normal, 3);
      plane(film.albedo, 3);
    }
  }

  std::array<double, 14 * PixelList::most_pixels> values_;
};

}  // namespace penumbra
