#include "sampling/pixel_filter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra {
namespace {

// e^x for -10 < x <= 0, from products and sums alone: the C library's may differ between machines.
double exponential(double x) {
  const double part = x / 1024;
  double power = 1 + part * (1 + part / 2 * (1 + part / 3 * (1 + part / 4)));
  for (int i = 0; i < 10; i++) power *= power;
  return power;
}

constexpr double reach_of_gaussian = 1.5;

// The filters, x pixels from the centre.
double value(PixelFilter filter, double x) {
  switch (filter) {
    case PixelFilter::box:
      return std::abs(x) < 0.5 ? 1 : 0;
    case PixelFilter::triangle:
      return std::max(1 - std::abs(x), 0.0);
    case PixelFilter::gaussian:
      return std::max(exponential(-2 * x * x) - exponential(-2 * reach_of_gaussian * reach_of_gaussian), 0.0);
  }
  return 0;
}

}  // namespace

FilterSteps make_filter_steps(PixelFilter filter) {
  constexpr std::size_t intervals = 8192, half = FilterSteps::count / 2;
  const double reach = filter == PixelFilter::gaussian ? reach_of_gaussian : 1;
  const double width = reach / intervals;
  std::vector<double> integral{0};  // from the centre on, by Simpson's rule
  for (std::size_t i = 0; i < intervals; i++) {
    const double x = static_cast<double>(i) * width;
    const double sum = value(filter, x) + 4 * value(filter, x + width / 2) + value(filter, x + width);
    integral.push_back(integral.back() + sum * width / 6);
  }
  FilterSteps steps;
  std::size_t i = 0;
  for (std::size_t step = 1; step <= half; step++) {
    const double goal = integral.back() * static_cast<double>(step) / half;
    while (i + 1 < intervals && integral[i + 1] < goal) i++;
    const double share = std::min((goal - integral[i]) / (integral[i + 1] - integral[i]), 1.0);
    const auto end = static_cast<float>((static_cast<double>(i) + share) * width);
    steps.ends[half + step] = end;
    steps.ends[half - step] = -end;
  }
  return steps;
}

}  // namespace penumbra
