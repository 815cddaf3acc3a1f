// No tile and no sample asks for memory or for a lock: a render with four times the samples or four times the tiles
// makes the same number of such calls, those that start its threads and add up their results.
#include <gtest/gtest.h>

#include <mutex>
#include <new>

#include "base/test_scale.hpp"
#include "rendering/all_effects.hpp"
#include "rendering/call_counts.hpp"
#include "rendering/film_values.hpp"
#include "rendering/render_adaptive.hpp"
#include "rendering/render_text.hpp"

namespace penumbra::test {

static void PrintTo(const CallCounts& calls, std::ostream* out) {
  *out << calls.allocations << " allocations, " << calls.locks << " locks";
}

namespace {

constexpr std::uint32_t few = scaled(8, 2);
constexpr int side = scaled(128, 64);

template <class Work>
CallCounts calls_of(const Work& work) {
  const CallCounts before = call_counts();
  work();
  const CallCounts after = call_counts();
  return {after.allocations - before.allocations, after.locks - before.locks};
}

PixelRect full(const Scene& scene) { return {0, 0, scene.settings.width, scene.settings.height}; }

// A frame, a small crop of it, and the full picture, which has four times the tiles.
struct Setting {
  Scene scene;
  Frame frame;
  PixelRect small{};

  explicit Setting(const std::string& text, Pattern pattern = default_pattern) : scene(scene_from(text)) {
    RenderSettings settings;
    settings.pattern = pattern;
    settings.threads = 1;  // Embree's threads would be counted, too
    scene.settings.width = scene.settings.height = side;
    frame = frame_from(scene, settings);
    small = {side / 4, side / 4, 3 * side / 4, 3 * side / 4};
  }

  CallCounts calls(const PixelRect& crop, std::uint32_t samples, int threads) const {
    Film film(crop, all_layers);
    RenderState state;
    const Kernel& kernel = *usable_kernels().back();
    return calls_of([&] { render_samples(film, frame, kernel, {crop, all_layers, threads}, {0, samples}, state); });
  }

  CallCounts adaptive_calls(const PixelRect& crop, float error, std::uint32_t most, int threads) const {
    Film film(crop, all_layers, SampleCounts::per_pixel);
    RenderState state;
    const Kernel& kernel = *usable_kernels().back();
    return calls_of([&] { render_adaptive(film, frame, kernel, {crop, all_layers, threads}, {error, most}, state); });
  }
};

// The counting itself.
TEST(RenderLoop, CallsAreCounted) {
  EXPECT_EQ(calls_of([] { ::operator delete(::operator new(1000)); }), (CallCounts{1, 0}));
  constexpr std::align_val_t wide{64};
  EXPECT_EQ(calls_of([] { ::operator delete(::operator new(64, wide), wide); }), (CallCounts{1, 0}));
  std::mutex mutex;
  EXPECT_EQ(calls_of([&] {
              for (int i = 0; i < 5; i++) const std::lock_guard lock(mutex);
            }),
            (CallCounts{0, 5}));
}

TEST(RenderLoop, NoPatternAddsCalls) {
  for (const Pattern pattern : all_patterns) {
    const Setting setting(scene_text(4 * few), pattern);
    const CallCounts calls = setting.calls(setting.small, few, 1);
    EXPECT_EQ(setting.calls(setting.small, 4 * few, 1), calls);
    EXPECT_EQ(setting.calls(full(setting.scene), few, 1), calls);
  }
}

TEST(RenderLoop, SamplesAndTilesAddNoCalls) {
  for (const std::string& text : {scene_text(4 * few), scene_text(4 * few) + mesh_text(),
                                  scene_text(4 * few) + "reflection_rays 3\ntransmission_rays 2\nshadow_rays 4\n"}) {
    const Setting setting(text);
    for (const int threads : {1, 3}) {
      setting.calls(setting.small, few, threads);  // the first threads of a process get new stacks
      const CallCounts calls = setting.calls(setting.small, few, threads);
      EXPECT_EQ(setting.calls(setting.small, 4 * few, threads), calls);
      EXPECT_EQ(setting.calls(full(setting.scene), few, threads), calls);
    }
  }
}

TEST(RenderLoop, AdaptiveSamplesAndTilesAddNoCalls) {
  constexpr std::uint32_t most = scaled(128, 32);
  for (const std::string& text : {scene_text(most), scene_text(most) + mesh_text()}) {
    const Setting setting(text);
    for (const int threads : {1, 3}) {
      setting.adaptive_calls(setting.small, 0.1f, most, threads);
      const CallCounts calls = setting.adaptive_calls(setting.small, 0.1f, most / 4, threads);
      EXPECT_EQ(setting.adaptive_calls(setting.small, 0.02f, most, threads), calls);
      EXPECT_EQ(setting.adaptive_calls({0, 0, side - 16, side - 16}, 0.1f, most / 4, threads), calls);
    }
  }
}

}  // namespace
}  // namespace penumbra::test
