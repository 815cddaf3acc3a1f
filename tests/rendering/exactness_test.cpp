// What must not show in a picture: threads, crops, passes, instruction sets. All of it to the bit, colours and layers.
#include <gtest/gtest.h>

#include <cstring>

#include "base/test_scale.hpp"
#include "rendering/all_effects.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {
namespace {

// Several rays from every first hit.
const std::string rays_of_hits = "reflection_rays 3\ntransmission_rays 2\nshadow_rays 4\n";

FilmValues rendered(const std::string& text, RenderSettings settings) {
  settings.layers = all_layers;
  return values_of(render_text(text, settings).film);
}

TEST(Exactness, ThreadsDoNotShow) {
  for (const std::string& text : {scene_text(scaled(37, 5)), scene_text(1), scene_text(3) + mesh_text()}) {
    RenderSettings settings;
    settings.threads = 1;
    const FilmValues one = rendered(text, settings);
    for (const int threads : {2, 3, 8}) {
      settings.threads = threads;
      EXPECT_TRUE(rendered(text, settings) == one) << threads;
    }
  }
}

TEST(Exactness, CropsAreTheSamePixels) {
  for (const Pattern pattern : all_patterns) {
    for (const std::string& text :
         {scene_text(1), scene_text(3), scene_text(scaled(21, 6)), scene_text(2) + mesh_text()}) {
      RenderSettings settings;
      settings.pattern = pattern;
      const FilmValues full = rendered(text, settings);
      for (const PixelRect crop : {PixelRect{0, 0, 53, 37}, PixelRect{5, 7, 29, 30}, PixelRect{52, 36, 53, 37},
                                   PixelRect{17, 0, 18, 37}, PixelRect{1, 35, 52, 36}}) {
        settings.crop = crop;
        const FilmValues part = rendered(text, settings);
        const auto same = [&](const ZeroedVector<float>& a, const ZeroedVector<float>& b, int channels) {
          int different = 0;
          for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
              const auto i = static_cast<std::size_t>(channels * (y * crop.width() + x));
              const auto k = static_cast<std::size_t>(channels * ((y + crop.y0) * 53 + x + crop.x0));
              different += std::memcmp(&a[i], &b[k], static_cast<std::size_t>(channels) * sizeof(float)) != 0;
            }
          }
          EXPECT_EQ(different, 0) << crop.x0 << " " << crop.y0 << " " << crop.x1 << " " << crop.y1;
        };
        for (const LayerRow& row : layer_table) {
          const std::size_t i = index_of(row.layer);
          same(part[i], full[i], static_cast<int>(row.channels.size()));
        }
      }
    }
  }
}

TEST(Exactness, PassesDoNotShow) {
  constexpr std::uint32_t rays = scaled(75, 20);
  const Scene scene = scene_from(scene_text(rays));
  for (const Kernel* kernel : usable_kernels()) {
    for (const Pattern pattern : all_patterns) {
      if (pattern != default_pattern && kernel != usable_kernels().back()) continue;
      RenderSettings settings;
      settings.pattern = pattern;
      settings.lens_model = pattern == Pattern::random ? LensModel::cone : LensModel::thin;
      settings.layers = all_layers;
      settings.kernel = kernel;
      const FilmValues at_once = values_of(render_scene(scene, settings).film);
      const Frame frame = frame_from(scene, settings);
      const Plan plan{{0, 0, scene.settings.width, scene.settings.height}, all_layers, 2};
      for (const std::vector<std::uint32_t>& cuts :
           {std::vector<std::uint32_t>{1, 2, 3, 4}, {1}, {16}, {5, 6, 19}, {8, 16, 17}, {rays - 1}}) {
        Film film(plan.crop, plan.layers);
        RenderState state;
        std::uint32_t first = 0;
        for (const std::uint32_t cut : cuts) {
          render_samples(film, frame, *kernel, plan, {first, cut}, state);
          first = cut;
        }
        render_samples(film, frame, *kernel, plan, {first, rays}, state);
        EXPECT_EQ(film.samples(), rays);
        EXPECT_TRUE(values_of(film) == at_once) << kernel->isa << " first cut " << cuts.front();
      }
    }
  }
}

TEST(Exactness, InstructionSetsDoNotShow) {
  for (const std::string& text :
       {scene_text(1), scene_text(3), scene_text(8), scene_text(scaled(33, 9)), scene_text(2) + rays_of_hits}) {
    for (const Pattern pattern : all_patterns) {
      RenderSettings settings;
      settings.pattern = pattern;
      settings.transparent_shadows = pattern == Pattern::random;
      settings.regular_lights = pattern == Pattern::halton;
      settings.kernel = usable_kernels().front();
      const FilmValues first = rendered(text, settings);
      for (const Kernel* kernel : usable_kernels()) {
        settings.kernel = kernel;
        EXPECT_TRUE(rendered(text, settings) == first)
            << kernel->isa << " " << pattern_names[static_cast<int>(pattern)];
      }
    }
  }
}

// Not even in the rays that aim the rays of a cone lens.
TEST(Exactness, NothingShowsWithAConeLens) {
  for (const std::string& text : {scene_text(1), scene_text(scaled(19, 5)), scene_text(3) + mesh_text()}) {
    RenderSettings settings;
    settings.lens_model = LensModel::cone;
    settings.kernel = usable_kernels().front();
    const FilmValues first = rendered(text, settings);
    settings.threads = 3;
    for (const Kernel* kernel : usable_kernels()) {
      settings.kernel = kernel;
      EXPECT_TRUE(rendered(text, settings) == first) << kernel->isa;
    }
  }
}

// More samples than the 65536 of the table: still the same whatever the passes.
TEST(Exactness, ManySamples) {
  constexpr std::uint32_t rays = 65536 + 100;
  const Scene scene = scene_from("image_size 2 1\nfov 30\nrays_per_pixel " + std::to_string(rays) +
                                 "\ndisk_light 1 5 0 1 0 1 0 1 1 1\nsphere 1 0.2 0 -4\nbox -9 -9 -9 9 9 -8\n");
  const FilmValues at_once = values_of(render_scene(scene).film);
  const Frame frame = frame_from(scene);
  const Plan plan{{0, 0, 2, 1}, {}, 1};
  Film film(plan.crop, plan.layers);
  RenderState state;
  render_samples(film, frame, *usable_kernels().front(), plan, {0, 65500}, state);
  render_samples(film, frame, *usable_kernels().back(), plan, {65500, 65541}, state);
  render_samples(film, frame, *usable_kernels().back(), plan, {65541, rays}, state);
  EXPECT_TRUE(values_of(film) == at_once);
}

TEST(Exactness, StaticPixelsDoNotSeeTheShutter) {
  // Only the ball moves, and only in the left half; its shadow stays there too.
  const std::string scene = R"(image_size 60 40
rays_per_pixel 7
light -1 8 1 1 1 1
disk_light 5 6 0 1 -1 -1 0 0.4 0.4 0.4
surface 0.5 0.6 0.7
sphere 1 2 0 -6
box 1 -2 -7 4 -1 -5
sphere 0.5 -3 0 -6
moving_object -1 0 0
)";
  for (const Pattern pattern : all_patterns) {
    RenderSettings settings;
    settings.pattern = pattern;
    const Picture3 open = render_text(scene, settings), closed = render_text("shutter 0 0\n" + scene, settings);
    int different_left = 0, different_right = 0, seen_right = 0;
    for (int y = 0; y < 40; y++) {
      for (int x = 0; x < 60; x++) {
        const bool differs = !(open.at(x, y) == closed.at(x, y));
        (x < 30 ? different_left : different_right) += differs;
        seen_right += x >= 30 && open.at(x, y).x > 0;
      }
    }
    EXPECT_GT(different_left, 10);
    EXPECT_EQ(different_right, 0) << pattern_names[static_cast<int>(pattern)];
    EXPECT_GT(seen_right, 100);
  }
}

// The light dimensions among the eye ray's belong to the first area light, not to a light that needs none.
TEST(Exactness, ABlackPointLightInFrontDoesNotShow) {
  const std::string disk = "disk_light 0 6 0 1 0 -1 0 0.4 0.5 0.6\nsphere 1 0 0 -5\nbox -9 -2 -9 9 -1 9\n";
  for (const Pattern pattern : {Pattern::sobol, Pattern::random, Pattern::jittered}) {
    RenderSettings settings;
    settings.pattern = pattern;
    const std::string size = "image_size 20 20\nrays_per_pixel 5\n";
    EXPECT_EQ(render_text(size + disk, settings).color,
              render_text(size + "light 0 9 0 0 0 0\n" + disk, settings).color);
  }
}

TEST(Exactness, StoppedRendersLeaveTheSampleCount) {
  const Scene scene = scene_from(scene_text(4));
  const Frame frame = frame_from(scene);
  const Plan plan{{0, 0, scene.settings.width, scene.settings.height}, {}, 2};
  Film film(plan.crop, plan.layers);
  RenderState state;
  state.stop = true;
  render_samples(film, frame, *usable_kernels().back(), plan, {0, 4}, state);
  EXPECT_EQ(film.samples(), 0u);
}

TEST(Exactness, ProgressCountsEverySample) {
  const Scene scene = scene_from(scene_text(5));
  const Frame frame = frame_from(scene);
  const Plan plan{{3, 4, 40, 30}, {}, 2};
  Film film(plan.crop, plan.layers);
  RenderState state;
  const RayCounts rays = render_samples(film, frame, *usable_kernels().back(), plan, {0, 5}, state);
  EXPECT_EQ(state.pixel_samples_done.load(), 37u * 26u * 5u);
  EXPECT_EQ(rays[RayKind::eye], 37u * 26u * 5u);
  EXPECT_EQ(state.rays.load(), rays.total());
  EXPECT_GT(rays[RayKind::shadow], 0u);
  EXPECT_GT(rays[RayKind::reflection], 0u);
  EXPECT_GT(rays[RayKind::transmission], 0u);
}

}  // namespace
}  // namespace penumbra::test
