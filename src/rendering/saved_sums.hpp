// The sums of one pixel of a film, kept aside while samples are added to it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "tracing/kernel.hpp"

namespace penumbra {

class SavedSums {
 public:
  SavedSums(const FilmView& film, std::size_t pixel) {
    double* next = values_.data();
    for_planes(film, pixel,
               [&next](const double* sums, std::size_t channels) { next = std::copy_n(sums, channels, next); });
  }

  void put_back(const FilmView& film, std::size_t pixel) const {
    const double* next = values_.data();
    for_planes(film, pixel, [&next](double* sums, std::size_t channels) {
      std::copy_n(next, channels, sums);
      next += channels;
    });
  }

 private:
  template <class Visit>
  static void for_planes(const FilmView& film, std::size_t pixel, const Visit& visit) {
    const auto plane = [&](double* sums, std::size_t channels) {
      if (sums) visit(sums + channels * pixel, channels);
    };
    plane(film.color, 3);
    plane(film.squares, 3);
    plane(film.depth, 2);
    plane(film.normal, 3);
    plane(film.albedo, 3);
  }

  std::array<double, 14> values_{};
};

}  // namespace penumbra
