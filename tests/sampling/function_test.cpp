// The packets' own elementary functions against the C library's in double precision, on dense inputs, within the errors
// stated in base/lane_math.hpp; and bit-identical for every instruction set.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/test_scale.hpp"
#include "probes/lane_probes.hpp"
#include "rendering/isa.hpp"

namespace penumbra::test {
namespace {

std::vector<float> values(const Kernel& kernel, LaneFunction function, const std::vector<float>& a,
                          const std::vector<float>& b, const std::vector<float>& c) {
  std::vector<float> out(a.size());
  probes_of(kernel).evaluate(function, a, b, c, out);
  return out;
}

std::vector<float> values(LaneFunction function, const std::vector<float>& a, const std::vector<float>& b = {}) {
  const std::vector<float> zeros(a.size());
  return values(*usable_kernels().back(), function, a, b.empty() ? zeros : b, zeros);
}

std::vector<float> dense(double lo, double hi, int count = scaled(1000001, 20001)) {
  std::vector<float> list;
  for (int i = 0; i < count; i++) list.push_back(static_cast<float>(lo + (hi - lo) * i / (count - 1)));
  return list;
}

// The largest error over all results.
double largest(const std::vector<float>& results, const std::function<double(std::size_t)>& exact, bool relative) {
  double error = 0;
  for (std::size_t i = 0; i < results.size(); i++) {
    const double e = exact(i);
    const double difference = std::abs(results[i] - e);
    error = std::max(error, relative ? difference / std::abs(e) : difference);
  }
  return error;
}

TEST(Functions, SineAndCosineOfTurns) {
  constexpr double turn = 2 * std::numbers::pi;
  for (const double range : {1.0, 100.0, 1048575.0}) {
    const std::vector<float> u = dense(-range, range);
    const auto exact = [&](auto function) {
      return [&u, function](std::size_t i) {
        const double part = double{u[i]} - std::floor(double{u[i]});  // exact
        return function(turn * part);
      };
    };
    const double sine = largest(values(LaneFunction::sine, u), exact([](double x) { return std::sin(x); }), false);
    const double cosine = largest(values(LaneFunction::cosine, u), exact([](double x) { return std::cos(x); }), false);
    EXPECT_LT(sine, 1.2e-7);
    EXPECT_LT(cosine, 1.2e-7);
  }
}

TEST(Functions, Log2) {
  std::vector<float> a = dense(0.5, 2.5);
  for (const float x : dense(-126, 127.9)) a.push_back(static_cast<float>(std::exp2(double{x})));
  const std::vector<float> results = values(LaneFunction::log2, a);
  double error = 0;
  for (std::size_t i = 0; i < a.size(); i++) {
    const double e = std::log2(double{a[i]});
    error = std::max(error, std::abs(results[i] - e) / std::max(1.0, std::abs(e)));
  }
  EXPECT_LT(error, 2e-7);
}

TEST(Functions, Exp2) {
  const std::vector<float> a = dense(-126, 126);
  const double error = largest(
      values(LaneFunction::exp2, a), [&](std::size_t i) { return std::exp2(double{a[i]}); }, true);
  EXPECT_LT(error, 2.5e-7);
  const std::vector<float> outside = values(LaneFunction::exp2, {-1000, -127, -126});
  for (const float v : outside) EXPECT_EQ(v, 0x1p-126f);
}

// The error of a power is that of the logarithm times the exponent.
TEST(Functions, Power) {
  double worst = 0;
  for (const float exponent : {0.5f, 1.0f, 2.0f, 5.0f, 10.0f, 50.0f, 300.0f, 1000.0f}) {
    const std::vector<float> a = dense(0.001, 1, scaled(100001, 5001));
    const std::vector<float> b(a.size(), exponent);
    const std::vector<float> results = values(LaneFunction::power, a, b);
    for (std::size_t i = 0; i < a.size(); i++) {
      const double e = std::pow(double{a[i]}, double{exponent});
      if (e < 0x1p-120) {
        EXPECT_LT(results[i], 0x1p-119);
        continue;
      }
      // log2 is off by up to 2e-7 times the larger of 1 and its magnitude.
      const double bound =
          3e-7 + 2e-7 * std::numbers::ln2 * exponent * std::max(1.0, std::abs(std::log2(double{a[i]})));
      worst = std::max(worst, std::abs(results[i] - e) / e / bound);
    }
  }
  EXPECT_LT(worst, 1);
}

// One exponent for all lanes and one per lane give the same bits.
TEST(Functions, WholePower) {
  double worst = 0;
  for (const float exponent : {1.0f, 2.0f, 3.0f, 10.0f, 50.0f, 255.0f, 4096.0f}) {
    const std::vector<float> a = dense(0, 1, scaled(100001, 5001));
    const std::vector<float> b(a.size(), exponent);
    const std::vector<float> results = values(LaneFunction::whole_power, a, b);
    EXPECT_EQ(results, values(LaneFunction::common_power, a, b)) << exponent;
    for (std::size_t i = 0; i < a.size(); i++) {
      const double e = std::pow(double{a[i]}, double{exponent});
      if (e < 0x1p-120) {
        EXPECT_LT(results[i], 0x1p-119);
        continue;
      }
      worst = std::max(worst, std::abs(results[i] - e) / e / (exponent * 0x1p-24));
    }
  }
  EXPECT_LT(worst, 1);
}

TEST(Functions, WholePowersOfEachLaneAreItsOwn) {
  std::vector<float> a, b;
  for (int i = 0; i < 1000; i++) {
    a.push_back(0.9f + 0.0001f * static_cast<float>(i));
    b.push_back(static_cast<float>(1 + i * 37 % 200));
  }
  const std::vector<float> together = values(LaneFunction::whole_power, a, b);
  for (std::size_t i = 0; i < a.size(); i++) {
    EXPECT_EQ(values(LaneFunction::common_power, {a[i]}, {b[i]})[0], together[i]) << a[i] << " to the " << b[i];
  }
}

TEST(Functions, PowerAtTheEnds) {
  const std::vector<float> a{0, 0, 0, 1, 1, 0.5f, 1e-30f};
  const std::vector<float> b{0, 1, 50, 0, 1e6f, 1e6f, 10};
  const std::vector<float> expected{1, 0, 0, 1, 1, 0, 0};
  EXPECT_EQ(values(LaneFunction::power, a, b), expected);
}

TEST(Functions, ArcCosineInTurns) {
  const std::vector<float> a = dense(-1, 1);
  const double error = largest(
      values(LaneFunction::acos_turns, a),
      [&](std::size_t i) { return std::acos(double{a[i]}) / (2 * std::numbers::pi); }, false);
  EXPECT_LT(error, 1e-7);
  EXPECT_NEAR(values(LaneFunction::acos_turns, {1.0f})[0], 0, 1e-7);
}

TEST(Functions, NoiseIsZeroAtWholeNumbersAndContinuous) {
  const Kernel& kernel = *usable_kernels().back();
  std::vector<float> x, y, z;
  for (int i = 0; i < 512; i++) {
    x.push_back(static_cast<float>(i % 8 - 4));
    y.push_back(static_cast<float>(i / 8 % 8 - 4));
    z.push_back(static_cast<float>(i / 64 - 4));
  }
  for (const float v : values(kernel, LaneFunction::noise, x, y, z)) EXPECT_EQ(v, 0);
  const std::vector<float> line = dense(-300, 300, 600001);
  const std::vector<float> half(line.size(), 0.37f), other(line.size(), -7.62f);
  const std::vector<float> noise = values(kernel, LaneFunction::noise, line, half, other);
  double smallest = 0, greatest = 0, step = 0;
  for (std::size_t i = 0; i < noise.size(); i++) {
    smallest = std::min(smallest, double{noise[i]});
    greatest = std::max(greatest, double{noise[i]});
    if (i > 0) step = std::max(step, double{std::abs(noise[i] - noise[i - 1])});
  }
  EXPECT_GT(smallest, -1.1);
  EXPECT_LT(smallest, -0.4);
  EXPECT_LT(greatest, 1.1);
  EXPECT_GT(greatest, 0.4);
  EXPECT_LT(step, 0.01);  // a slope of at most 10
}

TEST(Functions, SameBitsForEveryInstructionSet) {
  std::vector<float> a = dense(-3, 3, 30011), b = dense(0, 60, 30011), c = dense(0, 1, 30011);
  for (const LaneFunction function :
       {LaneFunction::sine, LaneFunction::cosine, LaneFunction::log2, LaneFunction::exp2, LaneFunction::power,
        LaneFunction::whole_power, LaneFunction::acos_turns, LaneFunction::disk_x, LaneFunction::disk_y,
        LaneFunction::ball_x, LaneFunction::ball_y, LaneFunction::ball_z, LaneFunction::noise}) {
    std::vector<float> in = a;
    const bool positive = function == LaneFunction::log2 || function == LaneFunction::power ||
                          function == LaneFunction::whole_power || function >= LaneFunction::disk_x;
    if (positive || function == LaneFunction::acos_turns) {
      for (float& x : in) x = std::abs(x) / 3.0f;
    }
    if (function == LaneFunction::log2) in[0] = 1;
    in[in.size() / 2] = 0.5f;
    const std::vector<float> first = values(*usable_kernels().front(), function, in, b, c);
    for (const Kernel* kernel : usable_kernels()) {
      const std::vector<float> other = values(*kernel, function, in, b, c);
      int different = 0;
      for (std::size_t i = 0; i < first.size(); i++) {
        different += std::bit_cast<std::uint32_t>(first[i]) != std::bit_cast<std::uint32_t>(other[i]);
      }
      EXPECT_EQ(different, 0) << kernel->isa << " function " << static_cast<int>(function);
    }
  }
}

}  // namespace
}  // namespace penumbra::test
