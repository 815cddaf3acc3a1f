// What the layers besides the colour mean: distance along the view, normal, surface colour, variance of the mean.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/test_scale.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

RenderSettings with_layers() {
  RenderSettings settings;
  settings.layers = all_layers;
  return settings;
}

TEST(Layers, HaveNames) {
  Layers layers;
  EXPECT_FALSE(layers.any());
  for (const std::string_view name : layer_names) {
    const Layers before = layers;
    EXPECT_TRUE(add_layer(layers, name));
    EXPECT_NE(layers, before) << name;
    EXPECT_TRUE(layers.any());
  }
  EXPECT_EQ(layers, all_layers);
  EXPECT_EQ(to_string(layers), "depth,normal,albedo,variance,samples");
  EXPECT_EQ(to_string(Layers{Layer::samples, Layer::normal}), "normal,samples");
  EXPECT_EQ(to_string(Layers()), "");
  for (const char* name : {"color", "dept", ""}) EXPECT_FALSE(add_layer(layers, name)) << name;
}

// A pixel's sums and its number of samples, as parts and checkpoints hold them.
TEST(Layers, TakeTheirBytes) {
  EXPECT_EQ(Film::bytes_per_pixel({}), 3 * 8u + 4);
  EXPECT_EQ(Film::bytes_per_pixel(all_layers), (3 + 2 + 3 + 3 + 3) * 8u + 4);
  for (const Layers& layers : {Layers{}, Layers{Layer::depth, Layer::variance}, all_layers}) {
    ArchiveWriter archive;
    Film({0, 0, 7, 5}, layers).write(archive, {2, 1, 5, 3});
    EXPECT_EQ(archive.bytes().size(), 6 * Film::bytes_per_pixel(layers));
  }
}

std::size_t pixel(int x, int y, int width) { return static_cast<std::size_t>(y * width + x); }

TEST(Layers, DepthIsAlongTheViewAndInfiniteOnAMiss) {
  // A wall at z = -7 that covers the right half; off the axis its depth is still 7.
  const Picture3 picture = render_text("image_size 40 30\nfov 80\nbox 0 -99 -8 99 99 -7\n", with_layers());
  const ZeroedVector<float> depth = picture.film.layer(Layer::depth);
  for (int y = 0; y < 30; y++) {
    for (int x = 0; x < 40; x++) {
      if (x < 20) {
        EXPECT_TRUE(std::isinf(depth[pixel(x, y, 40)]));
      } else if (x > 20) {
        EXPECT_NEAR(depth[pixel(x, y, 40)], 7, 1e-4);
      }
    }
  }
}

// Colours alone are summed differently from colours with layers. The test has more packets than that sum takes at once,
// and mirrors that amplify the light beyond its range.
TEST(Layers, DoNotShowInTheColour) {
  const std::string mirrors =
      "image_size 12 8\nrays_per_pixel 300\nmax_depth 12\nbackground 0.5 0.25 0.125\n"
      "light 0 0 0 1 1 1\nglossy 1 1 1 0 0 0 1 3 0.2\nbox -1 -1 -3 1 1 -2\nbox -1 -1 2 1 1 3\n";
  const Picture3 alone = render_text(mirrors), with = render_text(mirrors, with_layers());
  EXPECT_EQ(alone.film.color(), with.film.color());
  float brightest = 0;
  for (const float v : alone.film.color()) brightest = std::max(brightest, v);
  EXPECT_GT(brightest, 100);
}

TEST(Layers, DepthIsMeasuredFromTheEyeAndByHitsOnly) {
  // With a lens and jitter; half of the samples of the middle column miss.
  const std::string text = fmt::format(
      "image_size 9 9\nfov 40\nrays_per_pixel {}\nlens 0.2 4\neye 1 2 3\n"
      "uvw 0 0 1 0 1 0 -1 0 0\nbox 6 -99 3 6.0001 99 99\n",
      scaled(256, 64));
  const Picture3 picture = render_text(text, with_layers());
  const ZeroedVector<float> depth = picture.film.layer(Layer::depth);
  for (int y = 0; y < 9; y++) {
    EXPECT_TRUE(std::isinf(depth[pixel(0, y, 9)]));
    EXPECT_NEAR(depth[pixel(4, y, 9)], 5, 1e-4);
    EXPECT_NEAR(depth[pixel(8, y, 9)], 5, 1e-4);
  }
}

TEST(Layers, NormalAndAlbedoAreThoseOfTheFirstHit) {
  const std::string text =
      "image_size 30 20\nfov 60\nlight 0 5 0 0.1 0.1 0.1\nglossy 0.5 0.25 2 1 1 1 10 0.5 0.1\nsphere 1 0 0 -3\n";
  const Picture3 picture = render_text(text, with_layers());
  const ZeroedVector<float> normal = picture.film.layer(Layer::normal), albedo = picture.film.layer(Layer::albedo),
                            depth = picture.film.layer(Layer::depth);
  const double k = std::tan(30 * 3.14159265358979 / 180);
  int hits = 0;
  for (int y = 0; y < 20; y++) {
    for (int x = 0; x < 30; x++) {
      const double d = depth[pixel(x, y, 30)];
      if (std::isinf(d)) {
        EXPECT_EQ(picture.value(normal, x, y), Vec3{});
        EXPECT_EQ(picture.value(albedo, x, y), Vec3{});
        continue;
      }
      hits++;
      const Vec3 hit = Vec3{(x + 0.5 - 15) * 2 * k / 20, (10 - y - 0.5) * 2 * k / 20, -1} * d;
      EXPECT_LT(length(picture.value(normal, x, y) - (hit - Vec3{0, 0, -3})), 1e-4);
      EXPECT_LT(length(picture.value(albedo, x, y) - Vec3{0.5, 0.25, 2}), 1e-6);
    }
  }
  EXPECT_GT(hits, 30);
}

TEST(Layers, NormalOfATriangleTurnsToTheViewer) {
  for (const char* order :
       {"vertex -9 -9 -4\nvertex 9 -9 -4\nvertex 0 9 -4\n", "vertex 0 9 -4\nvertex 9 -9 -4\nvertex -9 -9 -4\n"}) {
    const Picture3 picture = render_text(fmt::format("image_size 1 1\nfov 1\nbegin\n{}end\n", order), with_layers());
    EXPECT_LT(length(picture.value(picture.film.layer(Layer::normal), 0, 0) - Vec3{0, 0, 1}), 1e-6);
  }
}

// A share p of the samples of a pixel sees 1, the rest 0: the mean of n has the variance p (1 - p) / n, estimated by
// m (1 - m) / (n - 1) from the mean m; and over many pixels the means vary by as much, within five standard errors of
// a variance, sqrt(2 / pixels).
TEST(Layers, VarianceOfABernoulliPixel) {
  constexpr int rays = 64, size = scaled(64, 24);
  RenderSettings settings = with_layers();
  settings.pattern = Pattern::random;
  // A disk light half hidden by an edge, seen on a floor patch so small that all pixels see the same.
  const std::string text = fmt::format(
      "image_size {0} {0}\nfov 0.001\nrays_per_pixel {1}\neye 0 2 0\nuvw 1 0 0 0 0 -1 0 1 0\n"
      "disk_light 0 1000 0 1 0 1 0 1 1 1\nsurface 1 1 1\nbox -9 -1 -9 9 0 9\nbox -900 400 -900 0 400.1 900\n",
      size, rays);
  const Picture3 picture = render_text(text, settings);
  const ZeroedVector<float> variance = picture.film.layer(Layer::variance);
  double sum = 0, squares = 0, estimates = 0;
  for (int y = 0; y < size; y++) {
    for (int x = 0; x < size; x++) {
      const double m = picture.at(x, y).x;
      sum += m;
      squares += m * m;
      estimates += variance[3 * pixel(x, y, size)];
      EXPECT_NEAR(variance[3 * pixel(x, y, size)], m * (1 - m) / (rays - 1), 1e-5);
    }
  }
  const double pixels = size * size;
  const double mean = sum / pixels;
  EXPECT_NEAR(mean, 0.5, 5 * 0.5 / std::sqrt(rays * pixels) + 1e-3);
  const double of_means = squares / pixels - mean * mean;
  EXPECT_NEAR(of_means, 0.25 / rays, 5 * std::sqrt(2 / pixels) * 0.25 / rays);
  EXPECT_NEAR(estimates / pixels, of_means, 6 * std::sqrt(2 / pixels) * 0.25 / rays);
}

TEST(Layers, VarianceIsZeroWhereNothingVaries) {
  for (const int rays : {1, 2, 16}) {
    const Picture3 picture =
        render_text(fmt::format("image_size 5 5\nrays_per_pixel {}\nbackground 0.3 100 1e-4\n", rays), with_layers());
    for (const float v : picture.film.layer(Layer::variance)) EXPECT_NEAR(v, 0, 1e-9);
  }
}

}  // namespace
}  // namespace penumbra::test
