// Adaptive rendering: the picture is as good as requested, the estimate of its error is honest, the rays go where the
// noise is, and how it was rendered does not show.
#include "rendering/adaptive.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <set>

#include "base/test_scale.hpp"
#include "rendering/film_values.hpp"
#include "rendering/noise_estimate.hpp"
#include "rendering/pixel_list.hpp"
#include "rendering/render_adaptive.hpp"
#include "rendering/render_text.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra::test {
namespace {

struct AdaptivePicture {
  Film film;
  AdaptiveResult result;

  double samples_per_pixel() const {
    return static_cast<double>(film.total_samples()) / (film.crop().width() * film.crop().height());
  }
};

AdaptivePicture render_noise(Scene scene, const NoiseGoal& goal, const RenderSettings& settings = {}) {
  scene.settings.rays_per_pixel = static_cast<int>(goal.most_rays);
  const Frame frame = frame_from(scene, settings);
  Plan plan;
  plan.crop = settings.crop.value_or(PixelRect{0, 0, scene.settings.width, scene.settings.height});
  plan.layers = settings.layers;
  plan.threads = settings.threads;
  Film film(plan.crop, plan.layers, SampleCounts::per_pixel);
  RenderState state;
  const Kernel& kernel = settings.kernel ? *settings.kernel : *usable_kernels().back();
  const AdaptiveResult result = render_adaptive(film, frame, kernel, plan, goal, state);
  return {std::move(film), result};
}

AdaptivePicture render_noise(const std::string& text, const NoiseGoal& goal, const RenderSettings& settings = {}) {
  return render_noise(scene_from(text, settings), goal, settings);
}

// Many rays, with another seed.
ZeroedVector<float> converged(const std::string& text, int rays) {
  Scene scene = scene_from(text);
  scene.settings.rays_per_pixel = rays;
  scene.settings.seed = 12345;
  return render_scene(scene).color;
}

double rmse_clamped(const ZeroedVector<float>& a, const ZeroedVector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); i++) {
    const double d = std::clamp(double{a[i]}, 0.0, 1.0) - std::clamp(double{b[i]}, 0.0, 1.0);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// A ball over a floor under two disk lights: soft shadows, edges, flat ground.
std::string shadow_text(int width, int height) {
  return fmt::format(
      "image_size {} {}\nfov 50\nbackground 0.2 0.4 0.8\ndisk_light 2 5 -4 0.9 0 -1 0 0.8 0.8 0.8\n"
      "disk_light -5 5 0 1.5 0 -1 0 0.3 0.25 0.2\nsurface 0.7 0.7 0.7\nbox -40 -2 -60 40 -1 10\n"
      "glossy 0.6 0.2 0.2 0.3 0.3 0.3 50 0 0\nsphere 1 0 0 -4\n",
      width, height);
}

// Blurred mirrors, a lens, and motion.
std::string blur_text(int width, int height) {
  return fmt::format(
      "image_size {} {}\nfov 50\nbackground 0.1 0.2 0.4\nlens 0.1 4\nlight 3 5 0 0.8 0.8 0.7\n"
      "glossy 0.2 0.2 0.2 0.4 0.4 0.4 60 0.5 0.1\nbox -40 -2 -60 40 -1 10\n"
      "diffuse 0.7 0.3 0.1 0.1 0.05 0\nsphere 0.7 -0.8 -0.3 -4\nmoving_object 0.4 0.2 0\n"
      "diffuse 0.1 0.5 0.3 0 0 0\nsphere 0.5 1 -0.5 -6\nsphere 0.3 0.4 -0.7 -2.5\n",
      width, height);
}

// Specks and hair lines, each a small part of a pixel, some much brighter than a pixel can show.
std::string specks_text(int width, int height) {
  std::string text = fmt::format("image_size {} {}\nfov 50\nbackground 0.05 0.06 0.1\n", width, height);
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < 12; i++) {
    const double brightness = i % 3 == 0 ? 6 : 1;
    text += fmt::format("diffuse 0 0 0 {0} {0} {0}\nsphere {1} {2} {3} -6\n", brightness, 0.008 + 0.02 * uniform(),
                        5 * uniform() - 2.5, 4 * uniform() - 2);
  }
  return text + "diffuse 0 0 0 0.9 0.8 0.7\npush\nrotatez 21\nbox -4 1 -6.01 4 1.012 -6\npop\n";
}

std::string all_effects_text() {
  return R"(image_size 53 37
fov 55
background 0.2 0.3 0.5
lens 0.05 5
disk_light -4 6 0 1.5 0.5 -1 0 0.4 0.5 0.6
light 3 5 2 0.5 0.4 0.3
surface 0.6 0.6 0.6
box -20 -2 -40 20 -1 20
glossy 0.4 0.3 0.2 0.5 0.5 0.5 30 0.4 0.2
sphere 0.9 -1 -0.1 -5
moving_object 0.5 0.2 0
translucent 0.1 0.2 0.1 0.4 0.4 0.4 60 0.2 0.1 0.6 1.5 0.05
box 0.5 -0.5 -5 1.5 0.5 -4
)";
}

// The same picture of one tile, pixel by pixel: each gets the four blocks of the first round; then, again and again,
// the samples of all pixels that are worth it are doubled, in two parts if there are 32 or more.
Film pixel_by_pixel(const Scene& scene, const NoiseGoal& goal) {
  const Frame frame = frame_from(scene);
  const Kernel& kernel = *usable_kernels().back();
  const AdaptiveRules rules(goal, frame);
  Film film({0, 0, noise_tile_size, noise_tile_size}, {}, SampleCounts::per_pixel);
  const FilmView view = film.view();
  RayCounts counts;
  const auto added = [&](Pixel pixel, std::uint32_t first, std::uint32_t end) {
    const ColorSum before = color_sum(view, pixel);
    kernel.render_pixels(frame, view, {{&pixel, 1}, first, end}, counts);
    return color_sum(view, pixel) - before;
  };
  NoiseWindow window{};
  const auto index_of = [](Pixel p) { return (p.y + noise_reach) * noise_window_size + p.x + noise_reach; };
  const PixelList all = pixels_of(film.crop());
  for (const Pixel& pixel : all.all()) {
    const std::uint32_t n = (1u << rules.first_level) / 4;
    std::array<ColorSum, 4> blocks;
    for (std::uint32_t i = 0; i < 4; i++) blocks[i] = added(pixel, i * n, (i + 1) * n);
    window[index_of(pixel)] = first_noise(blocks, rules.first_level);
  }
  for (bool any = true; any;) {
    any = false;
    const NoiseWindow before = window;
    const WindowNumbers rates = observed_rates(before, rules.rates);
    for (const Pixel& pixel : all.all()) {
      const std::size_t i = index_of(pixel);
      const int level = before[i].level;
      if (level == rules.most_level || !rules.is_worth_more(squared_error(before, i, rates[i]), level)) continue;
      const ColorSum sum = color_sum(view, pixel);
      const std::uint32_t n = before[i].samples();
      const ColorSum a = added(pixel, n, n + n / 2), b = added(pixel, n + n / 2, 2 * n);
      const SquaredDifference parts = squared_difference(a, b, n / 2.0);
      window[i] = doubled_noise(before[i], sum, a + b, n < 32 ? nullptr : &parts);
      any = true;
    }
  }
  for (const Pixel& pixel : all.all()) film.set_samples({&pixel, 1}, window[index_of(pixel)].samples());
  return film;
}

TEST(Adaptive, IsWhatPixelsOneByOneGive) {
  for (const std::string& text : {shadow_text(16, 16), blur_text(16, 16)}) {
    for (const float error : {0.02f, 0.005f}) {
      const NoiseGoal goal{error, 1024};
      Scene scene = scene_from(text);
      scene.settings.rays_per_pixel = static_cast<int>(goal.most_rays);
      const Film expected = pixel_by_pixel(scene, goal);
      const Film film = render_noise(scene, goal).film;
      const ZeroedVector<float> samples = film.layer(Layer::samples);
      EXPECT_GE(std::set<float>(samples.begin(), samples.end()).size(), 3u);
      EXPECT_TRUE(samples == expected.layer(Layer::samples));
      EXPECT_TRUE(film.color() == expected.color());
    }
  }
}

TEST(Adaptive, ThreadsAndInstructionSetsDoNotShow) {
  const NoiseGoal goal{scaled(1, 2) * 0.02f, 4096};
  for (const Pattern pattern : {Pattern::sobol, Pattern::random}) {
    RenderSettings settings;
    settings.layers = all_layers;
    settings.pattern = pattern;
    settings.threads = 1;
    settings.kernel = usable_kernels().front();
    const FilmValues one = values_of(render_noise(all_effects_text(), goal, settings).film);
    for (const Kernel* kernel : usable_kernels()) {
      settings.kernel = kernel;
      for (const int threads : {1, 2, 3}) {
        settings.threads = threads;
        EXPECT_TRUE(values_of(render_noise(all_effects_text(), goal, settings).film) == one)
            << kernel->isa << " " << threads;
      }
    }
  }
}

TEST(Adaptive, CropsAreTheSamePixels) {
  const NoiseGoal goal{scaled(1, 2) * 0.02f, 4096};
  RenderSettings settings;
  settings.layers = all_layers;
  const FilmValues full = values_of(render_noise(all_effects_text(), goal, settings).film);
  for (const PixelRect crop :
       {PixelRect{5, 7, 29, 30}, PixelRect{52, 36, 53, 37}, PixelRect{17, 0, 18, 37}, PixelRect{16, 16, 32, 32}}) {
    settings.crop = crop;
    const FilmValues part = values_of(render_noise(all_effects_text(), goal, settings).film);
    const auto expect_same = [&](const ZeroedVector<float>& a, const ZeroedVector<float>& b, int channels) {
      int different = 0;
      for (int i = 0; i < crop.width() * crop.height() * channels; i++) {
        const int x = i / channels % crop.width() + crop.x0, y = i / channels / crop.width() + crop.y0;
        const float whole = b[static_cast<std::size_t>((y * 53 + x) * channels + i % channels)];
        different += a[static_cast<std::size_t>(i)] != whole;
      }
      EXPECT_EQ(different, 0) << crop.x0 << " " << crop.y0;
    };
    for (const LayerRow& row : layer_table) {
      const std::size_t i = index_of(row.layer);
      expect_same(part[i], full[i], static_cast<int>(row.channels.size()));
    }
  }
}

TEST(Adaptive, ThePictureIsAsGoodAsAskedFor) {
  constexpr int width = scaled(48, 24), height = scaled(36, 18);
  for (const std::string& text : {shadow_text(width, height), blur_text(width, height), specks_text(width, height)}) {
    const ZeroedVector<float> truth = converged(text, scaled(4096, 512));
    double samples_before = 0;
    for (const float error : {0.02f, 0.01f}) {
      const AdaptivePicture picture = render_noise(text, {error, 1 << 16});
      EXPECT_LT(rmse_clamped(picture.film.color(), truth), 1.2 * error);
      EXPECT_EQ(picture.result.unfinished_pixels, 0u);
      EXPECT_GT(picture.samples_per_pixel(), samples_before);
      EXPECT_EQ(picture.result.rays[RayKind::eye], picture.film.total_samples());
      samples_before = picture.samples_per_pixel();
    }
  }
}

// Squares that cover this share of a pixel, one every eight pixels, anywhere in their pixel.
constexpr int squares_size = 48, squares_apart = 8;
std::string squares_text(double share, double brightness) {
  std::string text = fmt::format("image_size {0} {0}\nfov 90\ndiffuse 0 0 0 {1} {1} {1}\n", squares_size, brightness);
  std::mt19937 random(11);
  const double side = std::sqrt(share);
  const auto coordinate = [](double pixel) { return (pixel - squares_size / 2) * 2 / squares_size; };
  const auto within = [&](int pixel) { return pixel + (1 - side) * static_cast<double>(random()) / 4294967296.0; };
  for (int y = squares_apart / 2; y < squares_size; y += squares_apart) {
    for (int x = squares_apart / 2; x < squares_size; x += squares_apart) {
      const double px = within(x), py = within(y);
      text += fmt::format("box {} {} -1.0000001 {} {} -1\n", coordinate(px), -coordinate(py + side),
                          coordinate(px + side), -coordinate(py));
    }
  }
  return text;
}
constexpr int squares = (squares_size / squares_apart) * (squares_size / squares_apart);

// No speck is missed, and the pixels that specks cover in part are about as bright as they should be.
TEST(Adaptive, SpecksAreFound) {
  const AdaptivePicture picture = render_noise(squares_text(0.2, 1), {0.02f, 4096});
  const ZeroedVector<float> color = picture.film.color(), samples = picture.film.layer(Layer::samples);
  double sum = 0;
  int far_from_truth = 0, lit = 0;
  for (std::size_t i = 0; i < samples.size(); i++) {
    const double value = color[3 * i];
    sum += value;
    lit += value > 0;
    far_from_truth += value > 0 && std::abs(value - 0.2) > 0.06;  // three times the goal
  }
  EXPECT_EQ(lit, squares);
  EXPECT_EQ(far_from_truth, 0);
  EXPECT_NEAR(sum / squares, 0.2, 0.02);
}

// Lamps forty times as bright as white in 1/200 of a pixel, which makes 0.2: the first sixteen rays would miss nine in
// ten.
TEST(Adaptive, SmallLampsAreFound) {
  constexpr float error = 0.01f;
  const AdaptivePicture picture = render_noise(squares_text(0.005, 40), {error, 1 << 16});
  const ZeroedVector<float> color = picture.film.color();
  ZeroedVector<float> truth(color.size());
  for (int y = squares_apart / 2; y < squares_size; y += squares_apart) {
    for (int x = squares_apart / 2; x < squares_size; x += squares_apart) {
      for (int c = 0; c < 3; c++) truth[static_cast<std::size_t>(3 * (y * squares_size + x) + c)] = 0.2f;
    }
  }
  EXPECT_LT(rmse_clamped(color, truth), 1.2 * error);
}

TEST(Adaptive, MoreRaysWhereTheNoiseIs) {
  // A bright half plane, its edge at an angle through the middle of the picture.
  const AdaptivePicture picture = render_noise(
      "image_size 64 64\nfov 60\nbackground 0.1 0.1 0.1\ndiffuse 0 0 0 1 1 1\npush\nrotatez 17\n"
      "box 0 -99 -6 99 99 -5\npop\n",
      {0.01f, 4096});
  const ZeroedVector<float> samples = picture.film.layer(Layer::samples), color = picture.film.color();
  double edge = 0, flat = 0;
  int edge_pixels = 0, flat_pixels = 0;
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 64 + x); };
  for (int y = 0; y < 64; y++) {
    for (int x = 4; x < 60; x++) {
      const float left = color[3 * at(x - 4, y)], here = color[3 * at(x, y)], right = color[3 * at(x + 4, y)];
      if (left == here && here == right) {
        flat += samples[at(x, y)];
        flat_pixels++;
        EXPECT_EQ(samples[at(x, y)], 16) << x << " " << y;  // the first round's, and no more
      } else if (here > 0.3f && here < 0.8f) {
        edge += samples[at(x, y)];
        edge_pixels++;
      }
    }
  }
  ASSERT_GT(flat_pixels, 1000);
  ASSERT_GT(edge_pixels, 20);
  EXPECT_GT(edge / edge_pixels, 4 * flat / flat_pixels);
}

// The mean of the estimated variances is the mean square of the true errors, within a factor of 1.6. The variance that
// independent samples of the same spread would have is not.
TEST(Adaptive, TheVarianceIsHonest) {
  constexpr int width = scaled(64, 32), height = scaled(48, 24);
  constexpr double band = slow_build ? 4 : 1.6;  // a small picture has few pixels with any noise to go by
  struct Case {
    std::string text;
    Pattern pattern;
  };
  for (const Case& c :
       {Case{shadow_text(width, height), Pattern::sobol}, Case{blur_text(width, height), Pattern::sobol},
        Case{blur_text(width, height), Pattern::random}}) {
    const ZeroedVector<float> truth = converged(c.text, scaled(4096, 1024));
    RenderSettings settings;
    settings.layers.add(Layer::variance);
    settings.pattern = c.pattern;
    for (const float error : {0.03f, 0.015f}) {
      const AdaptivePicture picture = render_noise(c.text, {error, 1 << 16}, settings);
      const ZeroedVector<float> color = picture.film.color(), variance = picture.film.layer(Layer::variance);
      double estimated = 0, squared_errors = 0;
      for (std::size_t i = 0; i < color.size(); i++) {
        estimated += variance[i];
        squared_errors += (color[i] - truth[i]) * (color[i] - truth[i]);
      }
      EXPECT_GT(squared_errors / estimated, 1 / band) << error;
      EXPECT_LT(squared_errors / estimated, band) << error;
    }
  }
  Scene scene = scene_from(shadow_text(width, height));
  scene.settings.rays_per_pixel = 64;
  RenderSettings settings;
  settings.layers.add(Layer::variance);
  const Picture3 uniform = render_scene(scene, settings);
  const ZeroedVector<float> truth = converged(shadow_text(width, height), scaled(4096, 1024));
  const ZeroedVector<float> as_if_independent = uniform.film.layer(Layer::variance);
  double independent = 0, squared_errors = 0;
  for (std::size_t i = 0; i < truth.size(); i++) {
    independent += as_if_independent[i];
    squared_errors += (uniform.color[i] - truth[i]) * (uniform.color[i] - truth[i]);
  }
  EXPECT_LT(squared_errors / independent, 1 / 1.6);
}

TEST(Adaptive, TheMostRays) {
  RenderSettings settings;
  for (const std::uint32_t most : {4u, 7u, 64u, 100u}) {
    const AdaptivePicture picture = render_noise(shadow_text(32, 24), {1e-4f, most}, settings);
    EXPECT_GT(picture.result.unfinished_pixels, 100u);
    for (const float samples : picture.film.layer(Layer::samples)) EXPECT_LE(samples, static_cast<float>(most));
  }
  // In a crop, only its own pixels count.
  settings.crop = PixelRect{3, 4, 6, 6};
  EXPECT_LE(render_noise(blur_text(32, 24), {1e-5f, 64}, settings).result.unfinished_pixels, 6u);
}

TEST(Adaptive, StopEndsIt) {
  Scene scene = scene_from(shadow_text(32, 24));
  scene.settings.rays_per_pixel = 1 << 16;
  const Frame frame = frame_from(scene);
  const Plan plan{{0, 0, 32, 24}, {}, 2};
  Film film(plan.crop, plan.layers, SampleCounts::per_pixel);
  RenderState state;
  state.stop = true;
  const AdaptiveResult result = render_adaptive(film, frame, *usable_kernels().back(), plan, {1e-5f, 1 << 16}, state);
  EXPECT_EQ(result.rays.total(), 0u);
}

}  // namespace
}  // namespace penumbra::test
