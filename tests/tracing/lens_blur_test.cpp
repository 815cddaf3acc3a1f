// How much the two lens models blur, measured in pictures over a sweep of F, n, P and D and held against the formulas
//
//   r = (F / 2n) |D - P| / P,   in pixels   R = r S / (2 D tan(fov/2)).
//
// An edge that faces the camera, white to the right of x = 0 and black to the left at the same distance, is blurred by
// a uniform disk of radius R to the profile 1/2 + (s sqrt(1 - s^2) + asin s) / pi, s = x / R. A small ball is blurred
// to a disk with the mean square distance R^2 / 2. Independent samples; every test as a whole passes but for one seed
// in 10^6, and a radius that is wrong by 5 % fails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "base/test_scale.hpp"
#include "rendering/render_text.hpp"
#include "sampling/statistics.hpp"

namespace penumbra::test {
namespace {

struct Lens {
  double focal_length, f_number, focus;

  std::string command() const { return fmt::format("camera_lens {} {} {}\n", focal_length, f_number, focus); }
  double radius_at(double distance) const { return focal_length / (2 * f_number) * std::abs(distance - focus) / focus; }
};

constexpr int width = 96, height = 64;  // S = 64

double pixels_of(double radius, double distance, double half_view) {
  return radius * height / (2 * distance * half_view);
}

std::string view_of(double half_view, int rays) {
  return fmt::format("image_size {} {}\nfov {:.15g}\nrays_per_pixel {}\n", width, height,
                     2 * std::atan(half_view) * 180 / std::numbers::pi, rays);
}

// All combinations of a few values of each.
void sweep(const std::function<void(Lens, double)>& check) {
  for (const double focal_length : {0.2, 0.5, 1.0}) {
    for (const double f_number : {1.4, 4.0}) {
      for (const double focus : {3.0, 7.0}) {
        for (const double distance : {2.0, 4.5, 20.0}) check({focal_length, f_number, focus}, distance);
      }
    }
  }
}
constexpr int combinations = 36;

// How much of a uniform disk round 0 of radius 1 is to the right of -s.
double edge_profile(double s) {
  if (s <= -1) return 0;
  if (s >= 1) return 1;
  return 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / std::numbers::pi;
}

// The mean of a function of x over column i, x = 0 in the middle of the picture.
double over_column(int i, const std::function<double(double)>& f) {
  constexpr int steps = 16;
  double sum = 0;
  for (int k = 0; k < steps; k++) sum += f(i - width / 2.0 + (k + 0.5) / steps);
  return sum / steps;
}

// Half a plane at z = -distance, black (0) or white (1), left (-1) or right (1) of x = 0.
std::string half_plane(int side, int white, double distance) {
  return fmt::format(
      "diffuse 0 0 0 {0} {0} {0}\nbegin\nvertex 0 -999 {1}\nvertex {2} -999 {1}\nvertex {2} 999 {1}\n"
      "vertex 0 999 {1}\nend\n",
      white, -distance, side * 999);
}
std::string facing_edge(double distance) { return half_plane(-1, 0, distance) + half_plane(1, 1, distance); }

// The means of the columns of a few rows, and of how many samples each is the mean.
struct Profile {
  std::vector<double> mean;
  double samples = 0;
};

constexpr int edge_rows = 8, edge_rays = scaled(512, 128);

Profile measured_profile(const std::string& text, LensModel model, int rows = edge_rows) {
  RenderSettings settings;
  settings.pattern = Pattern::random;
  settings.lens_model = model;
  settings.crop = PixelRect{0, (height - rows) / 2, width, (height + rows) / 2};
  const Picture3 picture = render_text(text, settings);
  Profile profile;
  profile.samples = rows * edge_rays;
  for (int i = 0; i < width; i++) {
    double sum = 0;
    for (int j = settings.crop->y0; j < settings.crop->y1; j++) sum += picture.at(i, j).x;
    profile.mean.push_back(sum / rows);
  }
  return profile;
}

// Whether the columns are those of the profile, a function of x in pixels; one of `profiles` that are compared.
void expect_profile(const Profile& measured, const std::function<double(double)>& profile, int profiles) {
  const double limit = normal_limit(2.0 * width * profiles);
  for (int i = 0; i < width; i++) {
    const double p = over_column(i, profile);
    const double error = std::sqrt(std::max(p * (1 - p), 0.0) / measured.samples);
    // So far out in the tail of few events it is not quite a normal number.
    EXPECT_NEAR(measured.mean[static_cast<std::size_t>(i)], p, limit * error + 20 / measured.samples) << i;
  }
}

// A profile that depends on a radius too, both in pixels.
using RadialProfile = std::function<double(double x, double radius)>;

// By how much the radius of the measured profile is larger than `radius`, as a share of it, and the standard error of
// that: with w = dp / d(log R) in each column, sum w (mean - p) / sum w^2 is the estimate.
struct Excess {
  double share, error;
};
Excess radius_excess(const Profile& measured, double radius, const RadialProfile& profile) {
  double wd = 0, ww = 0, variance = 0;
  for (int i = 0; i < width; i++) {
    const double p = over_column(i, [&](double x) { return profile(x, radius); });
    const double w = (over_column(i, [&](double x) { return profile(x, radius * 1.001); }) - p) / 0.001;
    wd += w * (measured.mean[static_cast<std::size_t>(i)] - p);
    ww += w * w;
    variance += w * w * p * (1 - p) / measured.samples;
  }
  return {wd / ww, std::sqrt(variance) / ww};
}

// One of `radii` that are compared.
void expect_radius(const Profile& measured, double radius, const RadialProfile& profile, int radii) {
  const Excess excess = radius_excess(measured, radius, profile);
  EXPECT_LT(excess.error, scaled(1, 2) * 0.0075);
  EXPECT_NEAR(excess.share, 0, excess.error * normal_limit(2.0 * radii));
}

void check_edges(LensModel model) {
  sweep([&](const Lens& lens, double distance) {
    const double r = lens.radius_at(distance);
    const double half_view = 2 * r / distance;  // R = 16 pixels, but from the formula
    const double radius = pixels_of(r, distance, half_view);
    const Profile measured =
        measured_profile(view_of(half_view, edge_rays) + lens.command() + facing_edge(distance), model);
    SCOPED_TRACE(fmt::format("{}at {}", lens.command(), distance));
    expect_profile(
        measured, [&](double x) { return edge_profile(x / radius); }, combinations);
    expect_radius(
        measured, radius, [](double x, double of) { return edge_profile(x / of); }, combinations);
  });
}

TEST(LensBlur, OfAFacingEdgeThroughAThinLens) { check_edges(LensModel::thin); }

TEST(LensBlur, OfAFacingEdgeInACone) { check_edges(LensModel::cone); }

TEST(LensBlur, OfSmallBallsThroughAThinLens) {
  constexpr int rays = scaled(128, 48);
  sweep([&](const Lens& lens, double distance) {
    const double r = lens.radius_at(distance);
    const double ball = r / 4;
    const double half_view = 1.5 * (r + ball) / distance;
    RenderSettings settings;
    settings.pattern = Pattern::random;
    const Picture3 picture = render_text(view_of(half_view, rays) + lens.command() +
                                             fmt::format("diffuse 0 0 0 1 1 1\nsphere {} 0 0 {}\n", ball, -distance),
                                         settings);
    double sum = 0, squares = 0;
    for (int j = 0; j < height; j++) {
      for (int i = 0; i < width; i++) {
        const double x = i + 0.5 - width / 2.0, y = j + 0.5 - height / 2.0;
        sum += picture.at(i, j).x;
        squares += picture.at(i, j).x * (x * x + y * y);
      }
    }
    // The ball adds its own mean square, and the place in the pixel a sixth.
    const double ball_square = std::pow(pixels_of(ball, distance, half_view), 2) / 2;
    const double measured = std::sqrt(2 * (squares / sum - ball_square - 1.0 / 6));
    const double expected = pixels_of(r, distance, half_view);
    // The square of the distance from the middle of a uniform disk varies by 1 / sqrt(3) of its mean, its root by half
    // of that. What a ball is more than a flat disk is less than 0.005 here.
    const double error = expected / std::sqrt(12 * sum * rays);
    SCOPED_TRACE(fmt::format("{}at {}", lens.command(), distance));
    EXPECT_LT(error, scaled(1, 2) * 0.006 * expected);
    EXPECT_NEAR(measured, expected, error * normal_limit(2 * combinations) + 0.005 * expected);
  });
}

// Where the pinhole ray hits nothing, r / D = F / (2 n P), whatever D: the edge of a white half before nothing is
// blurred by that outside, and by the formula of its distance inside.
TEST(ConeLens, BesideTheEdgeOfEverything) {
  const Lens lens{0.5, 1.4, 3};
  constexpr double distances[] = {2, 20};
  for (const double distance : distances) {
    const double slope = lens.focal_length / (2 * lens.f_number * lens.focus);
    const double half_view = 2 * slope;
    const double inside = pixels_of(lens.radius_at(distance), distance, half_view);
    const double outside = height * slope / (2 * half_view);
    EXPECT_GT(outside, 1.1 * inside);
    const Profile measured = measured_profile(
        view_of(half_view, edge_rays) + lens.command() + half_plane(1, 1, distance), LensModel::cone, 4 * edge_rows);
    expect_profile(
        measured, [&](double x) { return edge_profile(x / (x < 0 ? outside : inside)); }, std::size(distances));
    expect_radius(
        measured, outside, [&](double x, double of) { return edge_profile(x / (x < 0 ? of : inside)); },
        2 * std::size(distances));
    expect_radius(
        measured, inside, [&](double x, double of) { return edge_profile(x / (x < 0 ? outside : of)); },
        2 * std::size(distances));
  }
}

// The pinhole ray has the time of the sample: an edge that runs away from the camera shows the mean of its profiles
// over the shutter's time.
TEST(LensBlur, OfAnEdgeThatMoves) {
  const Lens lens{0.5, 1.4, 3};
  const double half_view = 2 * lens.radius_at(8) / 8;
  constexpr double start = 2, way = 6;
  const std::string move = fmt::format("moving_object 0 0 {}\n", -way);
  const std::string text =
      view_of(half_view, edge_rays) + lens.command() + half_plane(-1, 0, start) + move + half_plane(1, 1, start) + move;
  const auto profile = [&](double x) {
    constexpr int steps = 500;
    double sum = 0;
    for (int k = 0; k < steps; k++) {
      const double distance = start + way * (k + 0.5) / steps;
      sum += edge_profile(x / pixels_of(lens.radius_at(distance), distance, half_view));
    }
    return sum / steps;
  };
  for (const LensModel model : {LensModel::thin, LensModel::cone}) {
    expect_profile(measured_profile(text, model), profile, 2);
  }
}

// The camera turned and shifted, and not of unit vectors: the cone too follows it.
TEST(ConeLens, FollowsTheCamera) {
  const Lens lens{0.5, 1.4, 3};
  constexpr double distance = 8;
  const double half_view = 2 * lens.radius_at(distance) / distance;
  // Looks along +x with z to the right, from (1, 2, 3); the edge is at z = 3.
  const auto half = [](int side, int white) {
    return fmt::format(
        "diffuse 0 0 0 {0} {0} {0}\nbegin\nvertex 9 -99 3\nvertex 9 -99 {1}\nvertex 9 99 {1}\n"
        "vertex 9 99 3\nend\n",
        white, 3 + side * 99);
  };
  const Profile measured = measured_profile(
      view_of(half_view, edge_rays) + lens.command() + "eye 1 2 3\nuvw 0 0 2 0 2 0 -2 0 0\n" + half(-1, 0) + half(1, 1),
      LensModel::cone);
  const double radius = pixels_of(lens.radius_at(distance), distance, half_view);
  expect_profile(
      measured, [&](double x) { return edge_profile(x / radius); }, 1);
}

// White squares on black at z = -distance, out to 45 degrees and more off the axis. Of equally far shapes the first is
// seen.
std::string squares(double distance) {
  std::string text = "diffuse 0 0 0 1 1 1\n";
  for (double x = -1.43; x < 1.3; x += 0.37) {
    for (double y = -1.39; y < 1.3; y += 0.37) {
      text += "begin\n";
      for (const auto& [dx, dy] : {std::pair(0.0, 0.0), {0.2, 0.0}, {0.2, 0.2}, {0.0, 0.2}}) {
        text += fmt::format("vertex {} {} {}\n", (x + dx) * distance, (y + dy) * distance, -distance);
      }
      text += "end\n";
    }
  }
  return text + half_plane(-1, 0, distance) + half_plane(1, 0, distance);
}

// What is in focus is a plane, not a sphere round the eye: in it, all over a wide picture, every sample sees what it
// sees through a pinhole, but for the few that pass an edge by less than a rounding error.
TEST(LensBlur, NoneInThePlaneInFocus) {
  constexpr int rays = 16;
  const auto samples_changed = [&](double distance, LensModel model) {
    const std::string scene =
        fmt::format("image_size 64 64\nfov 100\nrays_per_pixel {}\neye 0 0 0\n", rays) + squares(distance);
    RenderSettings settings;
    const ZeroedVector<float> sharp = render_text(scene, settings).color;
    settings.lens_model = model;
    const ZeroedVector<float> blurred = render_text("camera_lens 2 2 5\n" + scene, settings).color;
    double changed = 0;
    for (std::size_t i = 0; i < sharp.size(); i += 3) changed += std::abs(sharp[i] - blurred[i]) * rays;
    return changed;
  };
  for (const LensModel model : {LensModel::thin, LensModel::cone}) {
    EXPECT_LE(samples_changed(5, model), 8);
    EXPECT_GT(samples_changed(4, model), 1000);
    EXPECT_GT(samples_changed(7, model), 1000);
  }
}

// The camera's count is of samples: the pinhole rays that aim them are not in it.
TEST(ConeLens, CountsItsSamples) {
  RenderSettings settings;
  settings.lens_model = LensModel::cone;
  const RayCounts rays =
      render_text("image_size 20 10\nrays_per_pixel 5\ncamera_lens 1 2 5\nsphere 1 0 0 -4\n", settings).rays;
  EXPECT_EQ(rays[RayKind::eye], 1000u);
  EXPECT_EQ(rays.total(), 1000u);
}

// Without a lens the model is of no effect.
TEST(ConeLens, OfNoRadius) {
  const std::string scene = "image_size 20 20\nrays_per_pixel 3\nlight 3 4 5 1 1 1\nsphere 1 0.2 0.1 -4\n";
  RenderSettings settings;
  settings.lens_model = LensModel::cone;
  EXPECT_EQ(render_text(scene, settings).color, render_text(scene).color);
}

}  // namespace
}  // namespace penumbra::test
