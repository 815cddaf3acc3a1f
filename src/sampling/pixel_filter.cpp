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

// The filters, x pixels from the centre.
double value(PixelFilter filter, double x) {
  x = std::abs(x);
  switch (filter) {
    case PixelFilter::box:
      return x < 0.5 ? 1 : 0;
    case PixelFilter::triangle:
      return x < 1 ? 1 - x : 0;
    case PixelFilter::gaussian:
      return x < 1.5 ? exponential(-2 * x * x) - exponential(-2 * 1.5 * 1.5) : 0;
    case PixelFilter::mitchell:
      if (x < 1) return ((7 * x - 12) * x * x + 16.0 / 3) / 6;
      return x < 2 ? -7.0 / 18 * (x - 2) * (x - 2) * (x - 8.0 / 7) : 0;
  }
  return 0;
}

double reach(PixelFilter filter) {
  constexpr double reaches[] = {0.5, 1, 1.5, 2};
  return reaches[static_cast<int>(filter)];
}

// Part of a filter that has one sign, with its integral up to each of equal intervals.
struct Lobe {
  static constexpr int intervals = 4096;
  double low, high;
  std::vector<double> integral{0};

  Lobe(PixelFilter filter, double a, double b) : low(a), high(b) {
    const double width = (b - a) / intervals;
    for (int i = 0; i < intervals; i++) {
      const double x = a + i * width;
      const double simpson = value(filter, x) + 4 * value(filter, x + width / 2) + value(filter, x + width);
      integral.push_back(integral.back() + std::abs(simpson) * width / 6);
    }
  }
  double whole() const { return integral.back(); }

  // Where the integral is that share of the whole.
  double place(double share) const {
    const double goal = share * whole();
    int i = 0;
    while (i + 1 < intervals && integral[static_cast<std::size_t>(i) + 1] < goal) i++;
    const double before = integral[static_cast<std::size_t>(i)];
    const double own = integral[static_cast<std::size_t>(i) + 1] - before;
    return low + (high - low) / intervals * (i + (own > 0 ? std::min((goal - before) / own, 1.0) : 0));
  }
};

}  // namespace

FilterSteps make_filter_steps(PixelFilter filter) {
  constexpr auto count = static_cast<double>(FilterSteps::count);
  const double end = reach(filter), positive_end = filter == PixelFilter::mitchell ? 8.0 / 7 : end;
  const Lobe middle(filter, -positive_end, positive_end), left(filter, -end, -positive_end);
  const double negative = 2 * left.whole(), total = middle.whole() - negative;

  FilterSteps steps;
  steps.negative = static_cast<std::uint32_t>(std::lround(count / 2 * negative / (middle.whole() + negative)));
  const double outer = 2 * steps.negative, inner = count - outer;
  steps.weight = static_cast<float>(middle.whole() / total * count / inner);
  steps.negative_weight = outer > 0 ? static_cast<float>(-negative / total * count / outer) : 0;
  for (std::uint32_t i = 0; i <= FilterSteps::count / 2; i++) {
    const bool is_outer = i < steps.negative;
    const double place = is_outer ? left.place(2 * i / outer) : middle.place((i - steps.negative) / inner);
    steps.ends[i] = static_cast<float>(place);
    steps.ends[FilterSteps::count - i] = static_cast<float>(-place);
  }
  steps.ends[FilterSteps::count / 2] = 0;
  return steps;
}

}  // namespace penumbra
