// A render that is stopped anywhere, saved, and resumed as by another process gives the film of an unbroken one.
#include <gtest/gtest.h>

#include <random>

#include "sittings/pictures.hpp"
#include "sittings/stopping_kernel.hpp"

namespace penumbra::test {
namespace {

// How a render is stopped.
using Flag = std::atomic<bool> RenderState::*;

// The film of a render that is stopped after `calls()` calls of the kernel, again and again; and the number of
// sessions.
template <class Calls>
std::pair<FilmValues, int> in_sittings(const Setting& setting, int threads, Flag flag, const Calls& calls) {
  std::vector<std::byte> saved;
  for (int sittings = 1;; sittings++) {
    RenderState state;
    const StoppingKernel kernel(state.*flag);
    Setting now = setting;
    now.plan.threads = threads;
    const std::unique_ptr<ResumableRender> render = now.render(kernel.kernel());
    if (!saved.empty()) Checkpoint(saved, "test").restore(*render);
    StoppingKernel::stop_in_call(calls());
    render->run(state);
    if (render->is_finished()) return {values_of(render->take_film()), sittings};
    EXPECT_TRUE(state.*flag);
    saved = encode_checkpoint(now.key, {}, *render);
  }
}

class Resume : public testing::TestWithParam<PictureOfTest> {};

TEST_P(Resume, GivesTheUnbrokenFilm) {
  const Setting setting(GetParam());
  const FilmValues whole = unbroken(setting);
  std::mt19937 random(1);
  for (const int longest : {40, scaled(100, 400)}) {
    const auto calls = [&] { return 1 + static_cast<int>(random() % static_cast<unsigned>(longest)); };
    for (const int threads : {1, 3}) {
      for (const Flag flag : {&RenderState::stop, &RenderState::give_up}) {
        const auto [film, sittings] = in_sittings(setting, threads, flag, calls);
        EXPECT_TRUE(film == whole) << sittings << " sessions";
      }
    }
  }
}

// Every session makes progress, however short it is.
TEST_P(Resume, OneCallAtATime) {
  Setting setting(GetParam());
  PixelRect& crop = setting.plan.crop;
  crop = {crop.x0, crop.y0, crop.x0 + 9, crop.y0 + 3};
  const FilmValues whole = unbroken(setting);
  int most = 0;
  const auto [film, sittings] =
      in_sittings(setting, 1, &RenderState::stop, [&] { return setting.goal ? 1000 : (most++, 1); });
  EXPECT_TRUE(film == whole) << sittings << " sessions";
}

// Samples that are given up are neither in the film nor in the counts.
TEST_P(Resume, NothingIsLeftOfWhatIsGivenUp) {
  const Setting setting(GetParam());
  RenderState state;
  const StoppingKernel kernel(state.give_up);
  const std::unique_ptr<ResumableRender> render = setting.render(kernel.kernel());
  StoppingKernel::stop_in_call(1);
  const RayCounts rays = render->run(state);
  EXPECT_TRUE(state.give_up);
  EXPECT_EQ(rays.total(), 0u);
  EXPECT_EQ(state.rays, 0u);
  EXPECT_EQ(render->take_film().total_samples(), 0u);
}

// The same process continues, as it does after it has written a checkpoint.
TEST_P(Resume, GoesOnWithoutACheckpoint) {
  const Setting setting(GetParam());
  RenderState state;
  const StoppingKernel kernel(state.stop);
  const std::unique_ptr<ResumableRender> render = setting.render(kernel.kernel());
  std::mt19937 random(2);
  int stops = 0;
  RayCounts rays;
  for (; !render->is_finished(); stops++) {
    state.stop = false;
    StoppingKernel::stop_in_call(1 + static_cast<int>(random() % 30));
    rays += render->run(state);
  }
  EXPECT_GT(stops, 0);
  EXPECT_TRUE(values_of(render->take_film()) == unbroken(setting)) << stops << " stops";
}

INSTANTIATE_TEST_SUITE_P(Pictures, Resume, testing::ValuesIn(pictures_of_test()), [](const auto& of) {
  std::string name = of.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

// What is written for the user when a render is interrupted: each pixel's mean over its own samples.
TEST(PictureSoFar, IsTheMeanOfWhatThereIs) {
  const PictureOfTest picture{"", scene_text(64), {}};
  const Setting setting(picture);
  RenderState state;
  const StoppingKernel kernel(state.stop);
  const std::unique_ptr<ResumableRender> render = setting.render(kernel.kernel());
  StoppingKernel::stop_in_call(35 + 17);  // 35 quarters of 12 tiles: all have 16 samples, some 32
  render->run(state);
  ASSERT_FALSE(render->is_finished());
  const FilmValues so_far = values_of(render->take_film());

  const auto after = [&](std::uint32_t samples) {
    RenderState unstopped;
    Film film(setting.plan.crop, setting.plan.layers);
    render_samples(film, setting.frame, *usable_kernels().back(), setting.plan, {0, samples}, unstopped);
    return values_of(film);
  };
  const FilmValues first = after(16), second = after(32);
  int with_second = 0;
  const ZeroedVector<float>& samples = so_far[index_of(Layer::samples)];
  for (std::size_t i = 0; i < samples.size(); i++) {
    const FilmValues& expected = samples[i] == 32 ? second : first;
    with_second += samples[i] == 32;
    for (const LayerRow& row : layer_table) {
      const std::size_t layer = index_of(row.layer), channels = row.channels.size();
      for (std::size_t c = channels * i; c < channels * (i + 1); c++) ASSERT_EQ(so_far[layer][c], expected[layer][c]);
    }
  }
  EXPECT_EQ(with_second, 3 * 256 + 80 + 3 * 64);  // the fourth tile of a row is five pixels wide
}

// An adaptive render, too, has a complete picture after the first round.
TEST(PictureSoFar, OfAnAdaptiveRender) {
  const Setting setting({"", scene_text(256), 0.01f});
  RenderState state;
  const StoppingKernel kernel(state.stop);
  const std::unique_ptr<ResumableRender> render = setting.render(kernel.kernel());
  StoppingKernel::stop_in_call(4 * 12 + 20);  // four calls for each tile's first round
  render->run(state);
  ASSERT_FALSE(render->is_finished());
  const Film film = render->take_film();
  EXPECT_GE(film.samples(), 16u);
  EXPECT_GT(film.total_samples(), 53u * 37 * 16);
}

}  // namespace
}  // namespace penumbra::test
