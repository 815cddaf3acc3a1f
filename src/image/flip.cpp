// Section and equation names follow the paper: the colour pipeline (4.1: filter by contrast sensitivity, Hunt-adjusted
// L*a*b*, HyAB distance, compression) and the feature pipeline (4.2: edges and points), joined in 4.3. All filters are
// sums of separable ones and are applied as such; at the border the last pixel repeats.
#include "image/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/vec.hpp"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

struct Plane {
  int width, height;
  std::vector<float> values;
};

Plane make_plane(int width, int height) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
}

// sRGB primaries (IEC 61966-2-1) with white point D65.
Affine xyz_from_linear_rgb() {
  const auto of_chromaticity = [](double x, double y) { return Vec3{x / y, 1, (1 - x - y) / y}; };
  Affine primaries;
  primaries.column = {of_chromaticity(0.64, 0.33), of_chromaticity(0.30, 0.60), of_chromaticity(0.15, 0.06)};
  const Vec3 white = of_chromaticity(0.31271, 0.32902);
  return primaries * scaling(transform_vector(inverse(primaries), white));
}

struct ColourSpaces {
  Affine xyz_from_rgb = xyz_from_linear_rgb();
  Affine rgb_from_xyz = inverse(xyz_from_rgb);
  Vec3 white = transform_vector(xyz_from_rgb, {1, 1, 1});
};

Vec3 each(Vec3 v, double (*function)(double)) { return {function(v.x), function(v.y), function(v.z)}; }
Vec3 quotient(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }

// Written so that NaN becomes 0.
double clamped(double v) { return v > 0 ? (v < 1 ? v : 1) : 0; }

double linear_from_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

// The opponent space YCxCz: L*a*b* without its cube roots.
Vec3 opponent_from_rgb(const ColourSpaces& spaces, Vec3 rgb) {
  const Vec3 t = quotient(transform_vector(spaces.xyz_from_rgb, rgb), spaces.white);
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

Vec3 rgb_from_opponent(const ColourSpaces& spaces, Vec3 opponent) {
  const double y = (opponent.x + 16) / 116;
  const Vec3 t{y + opponent.y / 500, y, y - opponent.z / 200};
  return transform_vector(spaces.rgb_from_xyz, t * spaces.white);
}

// CIE 15: the cube root, continued by a line near zero.
double lab_root(double t) {
  constexpr double d = 6.0 / 29.0;
  return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29.0;
}

// L*a*b* with the chroma scaled by the lightness: the Hunt effect.
Vec3 hunt_lab_from_rgb(const ColourSpaces& spaces, Vec3 rgb) {
  const Vec3 f = each(quotient(transform_vector(spaces.xyz_from_rgb, rgb), spaces.white), lab_root);
  const double lightness = 116 * f.y - 16;
  return {lightness, 0.01 * lightness * 500 * (f.x - f.y), 0.01 * lightness * 200 * (f.y - f.z)};
}

// Abasi, Tehran, Fairchild 2020: city-block in lightness, Euclidean in chroma.
double hyab(Vec3 a, Vec3 b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// Weights for the offsets -r..r.
using Kernel = std::vector<double>;

Kernel gaussian(int radius, double standard_deviation) {
  Kernel kernel;
  for (int i = -radius; i <= radius; i++) {
    kernel.push_back(std::exp(-i * i / (2 * standard_deviation * standard_deviation)));
  }
  return kernel;
}

double sum_of(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

// Correlation with `across` along the rows.
Plane filter_rows(const Plane& plane, const Kernel& across) {
  const int radius = static_cast<int>(across.size() / 2);
  const auto width = static_cast<std::size_t>(plane.width);
  const std::vector<float> weights(across.begin(), across.end());
  Plane result = make_plane(plane.width, plane.height);
  std::vector<float> padded(width + across.size());
  for (std::size_t start = 0; start < plane.values.size(); start += width) {
    const float* row = &plane.values[start];
    for (std::size_t i = 0; i < padded.size(); i++) {
      padded[i] = row[std::clamp(static_cast<int>(i) - radius, 0, plane.width - 1)];
    }
    for (std::size_t i = 0; i < weights.size(); i++) {
      for (std::size_t x = 0; x < width; x++) result.values[start + x] += weights[i] * padded[x + i];
    }
  }
  return result;
}

// Correlation with `down` along the columns.
Plane filter_columns(const Plane& plane, const Kernel& down) {
  const int radius = static_cast<int>(down.size() / 2);
  const auto width = static_cast<std::size_t>(plane.width);
  const std::vector<float> weights(down.begin(), down.end());
  Plane result = make_plane(plane.width, plane.height);
  for (int y = 0; y < plane.height; y++) {
    float* out = &result.values[static_cast<std::size_t>(y) * width];
    for (std::size_t i = 0; i < weights.size(); i++) {
      const int source = std::clamp(y + static_cast<int>(i) - radius, 0, plane.height - 1);
      const float* row = &plane.values[static_cast<std::size_t>(source) * width];
      for (std::size_t x = 0; x < width; x++) out[x] += weights[i] * row[x];
    }
  }
  return result;
}

// One term a sqrt(pi/b) exp(-pi^2 d^2 / b) of a spatial contrast sensitivity function, d in degrees.
struct SensitivityTerm {
  double a, b;
};

// The paper's table of contrast sensitivity: achromatic, red-green, blue-yellow (the last has two terms).
using Sensitivity = std::vector<SensitivityTerm>;
const std::array<Sensitivity, 3>& sensitivities() {
  static const std::array<Sensitivity, 3> table{Sensitivity{{1, 0.0047}}, Sensitivity{{1, 0.0053}},
                                                Sensitivity{{34.1, 0.04}, {13.5, 0.025}}};
  return table;
}

// Filters the plane by one sensitivity function, scaled to sum 1. A term's standard deviation is sqrt(b / (2 pi^2))
// degrees; all filters reach three times the largest.
Plane filter_by_sensitivity(const Plane& plane, const Sensitivity& sensitivity, double pixels_per_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixels_per_degree));
  std::vector<Kernel> kernels;
  double total = 0;
  for (const auto& [a, b] : sensitivity) {
    kernels.push_back(gaussian(radius, std::sqrt(b / (2 * pi * pi)) * pixels_per_degree));
    total += a * std::sqrt(pi / b) * sum_of(kernels.back()) * sum_of(kernels.back());
  }
  Plane result = make_plane(plane.width, plane.height);
  for (std::size_t k = 0; k < kernels.size(); k++) {
    const double weight = sensitivity[k].a * std::sqrt(pi / sensitivity[k].b) / total;
    const Plane term = filter_columns(filter_rows(plane, scaled(kernels[k], weight)), kernels[k]);
    for (std::size_t i = 0; i < result.values.size(); i++) result.values[i] += term.values[i];
  }
  return result;
}

// The three opponent planes Y, Cx, Cz of a picture.
std::array<Plane, 3> opponent_planes(const ColourSpaces& spaces, const Image& image) {
  const Plane plane = make_plane(image.width, image.height);
  std::array<Plane, 3> planes{plane, plane, plane};
  for (std::size_t i = 0; i < plane.values.size(); i++) {
    const float* rgb = &image.rgb[3 * i];
    const Vec3 srgb = each({rgb[0], rgb[1], rgb[2]}, clamped);
    const Vec3 opponent = opponent_from_rgb(spaces, each(srgb, linear_from_srgb));
    for (int c = 0; c < 3; c++) planes[static_cast<std::size_t>(c)].values[i] = static_cast<float>(opponent[c]);
  }
  return planes;
}

std::array<Plane, 3> filtered_by_sensitivity(const std::array<Plane, 3>& planes, double pixels_per_degree) {
  const auto& table = sensitivities();
  return {filter_by_sensitivity(planes[0], table[0], pixels_per_degree),
          filter_by_sensitivity(planes[1], table[1], pixels_per_degree),
          filter_by_sensitivity(planes[2], table[2], pixels_per_degree)};
}

Vec3 perceived(const ColourSpaces& spaces, const std::array<Plane, 3>& planes, std::size_t i) {
  const Vec3 rgb = rgb_from_opponent(spaces, {planes[0].values[i], planes[1].values[i], planes[2].values[i]});
  return hunt_lab_from_rgb(spaces, each(rgb, clamped));
}

constexpr double compression_exponent = 0.7;  // the paper's q_c

// The largest HyAB distance within the sRGB gamut, between green and blue, compressed.
double largest_colour_distance(const ColourSpaces& spaces) {
  const Vec3 green = hunt_lab_from_rgb(spaces, {0, 1, 0}), blue = hunt_lab_from_rgb(spaces, {0, 0, 1});
  return std::pow(hyab(green, blue), compression_exponent);
}

// Maps a HyAB distance to an error in 0..1: distances up to p_c = 0.4 of the largest fill the range up to p_t = 0.95.
double colour_error(double distance, double largest) {
  constexpr double pc = 0.4, pt = 0.95;
  const double compressed = std::pow(distance, compression_exponent), knee = pc * largest;
  if (compressed < knee) return pt / knee * compressed;
  return pt + (compressed - knee) / (largest - knee) * (1 - pt);
}

// Scales the negative weights to sum -1 and the positive ones to sum 1, separately.
Kernel balanced(Kernel kernel) {
  double negative = 0, positive = 0;
  for (const double weight : kernel) (weight < 0 ? negative : positive) += std::abs(weight);
  for (double& weight : kernel) weight /= weight < 0 ? negative : positive;
  return kernel;
}

// The strength of edges and points: the magnitudes of the first and second derivatives along x and y.
struct Features {
  std::vector<float> edges, points;
};

std::vector<float> gradient_length(const Plane& plane, const Kernel& derivative, const Kernel& smoothing) {
  const Plane along_x = filter_columns(filter_rows(plane, derivative), smoothing);
  const Plane along_y = filter_columns(filter_rows(plane, smoothing), derivative);
  std::vector<float> length(plane.values.size());
  for (std::size_t i = 0; i < length.size(); i++) length[i] = std::hypot(along_x.values[i], along_y.values[i]);
  return length;
}

Features features_of(Plane achromatic, double pixels_per_degree) {
  for (float& v : achromatic.values) v = (v + 16) / 116;
  // Humans see edges as lines w = 0.082 degrees wide; the standard deviation is half of that.
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const Kernel bell = gaussian(radius, deviation);
  Kernel edge = bell, point = bell;
  for (std::size_t k = 0; k < bell.size(); k++) {
    const double x = static_cast<double>(k) - radius;
    edge[k] *= -x;
    point[k] *= x * x / (deviation * deviation) - 1;
  }
  const Kernel smoothing = scaled(bell, 1 / sum_of(bell));
  return {gradient_length(achromatic, balanced(edge), smoothing),
          gradient_length(achromatic, balanced(point), smoothing)};
}

double feature_error(const Features& a, const Features& b, std::size_t i) {
  const double edges = std::abs(a.edges[i] - b.edges[i]), points = std::abs(a.points[i] - b.points[i]);
  constexpr double feature_exponent = 0.5;  // the paper's q_f
  return std::min(1.0, std::pow(std::max(edges, points) / std::numbers::sqrt2, feature_exponent));
}

}  // namespace

std::vector<float> flip_map(const Image& reference, const Image& test, double pixels_per_degree) {
  const ColourSpaces spaces;
  std::array<Plane, 3> planes_a = opponent_planes(spaces, reference), planes_b = opponent_planes(spaces, test);
  const Features features_a = features_of(planes_a[0], pixels_per_degree);
  const Features features_b = features_of(planes_b[0], pixels_per_degree);
  planes_a = filtered_by_sensitivity(planes_a, pixels_per_degree);
  planes_b = filtered_by_sensitivity(planes_b, pixels_per_degree);

  const double largest = largest_colour_distance(spaces);
  std::vector<float> map(planes_a[0].values.size());
  for (std::size_t i = 0; i < map.size(); i++) {
    const double colour = colour_error(hyab(perceived(spaces, planes_a, i), perceived(spaces, planes_b, i)), largest);
    map[i] = static_cast<float>(std::pow(colour, 1 - feature_error(features_a, features_b, i)));
  }
  return map;
}

double flip(const Image& reference, const Image& test) {
  const std::vector<float> map = flip_map(reference, test);
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

}  // namespace penumbra
