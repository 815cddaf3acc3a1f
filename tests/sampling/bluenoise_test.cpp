// `bluenoise` spreads its error over the screen as blue noise: below 1/16 cycle per pixel it has less than a tenth of
// the power of independent points. In each pixel its points are nets, uniform over the seeds, and as good as those of
// `sobol`. The statistical limits leave one seed in a million to chance (statistics.hpp).
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "base/test_scale.hpp"
#include "sampling/points.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

constexpr double turn = 2 * std::numbers::pi;

struct Integrand {
  const char* name;
  std::function<double(double, double)> value;
};

// Edges and smooth functions, on the square and on the disk to which it is warped for lights and lenses.
const std::vector<Integrand> integrands = {
    {"step in u", [](double u, double) { return u < 0.37 ? 1.0 : 0.0; }},
    {"step in v", [](double, double v) { return v < 0.58 ? 1.0 : 0.0; }},
    {"diagonal edge", [](double u, double v) { return u + v < 1 ? 1.0 : 0.0; }},
    {"half plane", [](double u, double v) { return u - 2.3 * v < -0.52 ? 1.0 : 0.0; }},
    {"another half plane", [](double u, double v) { return 0.8 * u + 0.3 * v < 0.43 ? 1.0 : 0.0; }},
    {"product", [](double u, double v) { return u * v; }},
    {"radius", [](double u, double) { return std::sqrt(u); }},
    {"place on the disk", [](double u, double v) { return std::sqrt(u) * std::cos(turn * v); }},
    {"half of the disk",
     [](double u, double v) { return std::sqrt(u) * std::cos(turn * (v + 0.1)) < 0.2 ? 1.0 : 0.0; }},
};

double mean_value(const Integrand& integrand) {
  constexpr int size = 1000;
  double sum = 0;
  for (int i = 0; i < size * size; i++) sum += integrand.value((i % size + 0.5) / size, (i / size + 0.5) / size);
  return sum / (size * size);
}

constexpr int screen = 128;

// The estimates of all pixels from `rays` points each, for every integrand.
std::vector<std::vector<double>> estimates(Pattern pattern, std::size_t rays, Dimensions dimensions,
                                           std::uint32_t seed) {
  const Frame frame = sampling_frame(pattern, static_cast<std::uint32_t>(rays), seed);
  std::vector<std::vector<double>> result(integrands.size());
  for (int y = 0; y < screen; y++) {
    for (int x = 0; x < screen; x++) {
      const Points p = points_of(frame, x, y, dimensions, rays);
      for (std::size_t f = 0; f < integrands.size(); f++) {
        double sum = 0;
        for (std::size_t i = 0; i < rays; i++) sum += integrands[f].value(p.u[i], p.v[i]);
        result[f].push_back(sum / static_cast<double>(rays));
      }
    }
  }
  return result;
}

// The mean power at frequencies below `band` cycles per pixel, except zero; for white noise it is the variance.
double low_power(const std::vector<double>& picture, double band) {
  const int most = static_cast<int>(band * screen);
  double power = 0;
  int count = 0;
  for (int fx = 0; fx <= most; fx++) {
    std::vector<std::complex<double>> rows(screen);
    for (int x = 0; x < screen; x++) {
      const std::complex<double> wave = std::polar(1.0, -turn * fx * x / screen);
      for (int y = 0; y < screen; y++) {
        rows[static_cast<std::size_t>(y)] += picture[static_cast<std::size_t>(y * screen + x)] * wave;
      }
    }
    for (int fy = -most; fy <= most; fy++) {
      if (std::hypot(fx, fy) >= band * screen || (fx == 0 && fy <= 0)) continue;
      std::complex<double> sum = 0;
      for (int y = 0; y < screen; y++) {
        sum += rows[static_cast<std::size_t>(y)] * std::polar(1.0, -turn * fy * y / screen);
      }
      power += std::norm(sum) / (screen * screen);
      count++;
    }
  }
  return power / count;
}

// The power of the worst integrand at low frequencies, as a fraction of that of `random` with as many rays.
struct LowShare {
  double worst;
  const char* name;
};
LowShare low_share(Pattern pattern, std::size_t rays, double band) {
  std::vector<double> own(integrands.size()), white(integrands.size());
  for (std::uint32_t seed = 0; seed < 2; seed++) {
    const Dimensions dimensions = all_dimensions[seed % 2 == 0 ? 0 : 3];
    const auto pictures = estimates(pattern, rays, dimensions, seed);
    const auto random = estimates(Pattern::random, rays, dimensions, seed + 100);
    for (std::size_t f = 0; f < integrands.size(); f++) {
      own[f] += low_power(pictures[f], band);
      white[f] += low_power(random[f], 0.25);
    }
  }
  LowShare share{0, ""};
  for (std::size_t f = 0; f < integrands.size(); f++) {
    if (own[f] / white[f] > share.worst) share = {own[f] / white[f], integrands[f].name};
  }
  return share;
}

TEST(BlueNoise, LowFrequenciesAreQuiet) {
  if (slow_build) GTEST_SKIP() << "whole screens are slow here";
  for (const std::size_t rays : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
    const LowShare share = low_share(Pattern::bluenoise, rays, 1.0 / 16);
    EXPECT_LT(share.worst, 0.1) << rays << " rays: " << share.name;
  }
}

// The same measurement of patterns that ignore the neighbouring pixels.
TEST(BlueNoise, OtherPatternsAreNotQuiet) {
  if (slow_build) GTEST_SKIP() << "whole screens are slow here";
  for (const Pattern pattern : {Pattern::random, Pattern::sobol}) {
    const LowShare share = low_share(pattern, 1, 1.0 / 16);
    EXPECT_GT(share.worst, 0.8) << share.name;
  }
}

// Single points of two pixels over many seeds.
TEST(BlueNoise, EachPointIsUniformOverTheSeeds) {
  const int seeds = scaled(8000, 4000);
  const double limit = normal_limit(3 * 2 * 3);
  for (const Dimensions dimensions : {all_dimensions[0], all_dimensions[1], all_dimensions[3]}) {
    std::vector<std::vector<int>> counts(6, std::vector<int>(256));
    for (int seed = 0; seed < seeds; seed++) {
      const Frame frame = sampling_frame(Pattern::bluenoise, 6, static_cast<std::uint32_t>(seed));
      for (std::size_t pixel = 0; pixel < 2; pixel++) {
        const int x = pixel == 0 ? 0 : 777, y = pixel == 0 ? 0 : 31;
        const Points p = points_of(frame, x, y, dimensions, 6);
        for (std::size_t k = 0; k < 3; k++) {
          const std::size_t i = k == 0 ? 0 : 2 * k + 1;
          counts[pixel * 3 + k][static_cast<std::size_t>(p.u[i] * 16) * 16 + static_cast<std::size_t>(p.v[i] * 16)]++;
        }
      }
    }
    for (const std::vector<int>& count : counts) EXPECT_LT(chi_square_deviation(count), limit);
  }
}

// The first 2^m points and all later aligned blocks of the same size have one point in each elementary interval.
TEST(BlueNoise, PointsOfAPixelAreNets) {
  const Frame frame = sampling_frame(Pattern::bluenoise, 1024, 3);
  for (const Dimensions dimensions : all_dimensions) {
    const Points points = points_of(frame, 200, 77, dimensions, 1024);
    for (int m = 0; m <= 10; m++) {
      const std::size_t size = std::size_t{1} << m;
      for (std::size_t begin = 0; begin < 1024; begin += size) {
        for (int a = 0; a <= m; a++) {
          std::vector<int> counts(size);
          for (std::size_t i = begin; i < begin + size; i++) {
            const auto column = static_cast<std::size_t>(points.u[i] * static_cast<float>(1 << a));
            const auto row = static_cast<std::size_t>(points.v[i] * static_cast<float>(1 << (m - a)));
            counts[(column << (m - a)) + row]++;
          }
          for (const int count : counts) ASSERT_EQ(count, 1) << begin << ", 2^" << m << " points, " << a;
        }
      }
    }
  }
}

// Over many pixels, the mean squared errors of the estimates are less than 1.5 times those of `sobol` in the geometric
// mean over all integrands, and less than 3 times for each.
TEST(BlueNoise, IsAsGoodAsSobolInEveryPixel) {
  const int pixels = scaled(400, 100);
  for (const std::size_t rays : {std::size_t{16}, std::size_t{24}, std::size_t{64}, std::size_t{256}}) {
    double logarithms = 0;
    std::vector<double> errors[2] = {std::vector<double>(integrands.size()), std::vector<double>(integrands.size())};
    for (int k = 0; k < 2; k++) {
      for (std::uint32_t seed = 0; seed < 4; seed++) {
        const Frame frame =
            sampling_frame(k == 0 ? Pattern::bluenoise : Pattern::sobol, static_cast<std::uint32_t>(rays), seed);
        for (int pixel = 0; pixel < pixels; pixel++) {
          const Points p = points_of(frame, pixel % 20 * 7, pixel / 20 * 5, all_dimensions[3], rays);
          for (std::size_t f = 0; f < integrands.size(); f++) {
            static const std::vector<double> means = [] {
              std::vector<double> list;
              for (const Integrand& integrand : integrands) list.push_back(mean_value(integrand));
              return list;
            }();
            double sum = 0;
            for (std::size_t i = 0; i < rays; i++) sum += integrands[f].value(p.u[i], p.v[i]);
            const double error = sum / static_cast<double>(rays) - means[f];
            errors[k][f] += error * error;
          }
        }
      }
    }
    for (std::size_t f = 0; f < integrands.size(); f++) {
      const double ratio = errors[0][f] / errors[1][f];
      logarithms += std::log(ratio);
      EXPECT_LT(ratio, 3) << integrands[f].name << ", " << rays << " rays";
    }
    EXPECT_LT(std::exp(logarithms / static_cast<double>(integrands.size())), 1.5) << rays << " rays";
  }
}

// Across the screen, no dimension says anything about another.
TEST(BlueNoise, DimensionsAreNotCorrelated) {
  const Frame frame = sampling_frame(Pattern::bluenoise, 4, 7);
  const int size = scaled(128, 64);
  std::vector<std::vector<float>> columns(2 * std::size(all_dimensions));
  for (std::size_t d = 0; d < std::size(all_dimensions); d++) {
    for (int y = 0; y < size; y++) {
      for (int x = 0; x < size; x++) {
        const Points p = points_of(frame, x, y, all_dimensions[d], 1);
        columns[2 * d].push_back(p.u[0]);
        columns[2 * d + 1].push_back(p.v[0]);
      }
    }
  }
  const double limit = normal_limit(2 * columns.size() * columns.size() / 2.0);
  for (std::size_t a = 0; a < columns.size(); a++) {
    for (std::size_t b = 0; b < a; b++) {
      EXPECT_LT(std::abs(correlation(columns[a], columns[b])) * size, limit) << a << " " << b;
      std::vector<int> counts(256);
      for (std::size_t i = 0; i < columns[a].size(); i++) {
        counts[static_cast<std::size_t>(columns[a][i] * 16) * 16 + static_cast<std::size_t>(columns[b][i] * 16)]++;
      }
      EXPECT_LT(chi_square_deviation(counts), limit) << a << " " << b;
    }
  }
}

// Within a pixel, the squared correlation of two dimensions over n points is that of random pairing, or up to 2.5 times
// it (because the points of an octave stay together).
TEST(BlueNoise, DimensionsPairUpAtRandom) {
  for (const std::size_t count : {std::size_t{16}, std::size_t{64}, std::size_t{256}}) {
    const Frame frame = sampling_frame(Pattern::bluenoise, static_cast<std::uint32_t>(count), 8);
    const int pixels = scaled(1024, 256);
    double squares = 0;
    for (int pixel = 0; pixel < pixels; pixel++) {
      const Points a = points_of(frame, pixel % 32, pixel / 32, all_dimensions[0], count);
      const Points b = points_of(frame, pixel % 32, pixel / 32, all_dimensions[3], count);
      for (const auto& [x, y] : {std::pair(&a.u, &b.u), {&a.v, &b.v}, {&a.u, &b.v}, {&a.v, &b.u}}) {
        squares += correlation(*x, *y) * correlation(*x, *y) / 4;
      }
    }
    const double mean = squares / pixels * (static_cast<double>(count) - 1);
    EXPECT_LT(mean, 2.5) << count << " points";
  }
}

TEST(BlueNoise, SameBitsForEveryInstructionSet) {
  const Frame frame = sampling_frame(Pattern::bluenoise, 40, 2);
  for (const Kernel* kernel : usable_kernels()) {
    for (const Dimensions dimensions : all_dimensions) {
      const Points a = points_of(frame, 130, 5, dimensions, 40), b = points_of(frame, 130, 5, dimensions, 40, *kernel);
      EXPECT_EQ(a.u, b.u) << kernel->isa;
      EXPECT_EQ(a.v, b.v) << kernel->isa;
    }
  }
}

}  // namespace
}  // namespace penumbra::test
