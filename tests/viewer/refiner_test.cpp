#include "viewer/refiner.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/test_folder.hpp"
#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

using namespace std::chrono_literals;

const std::string scene_text = R"(image_size 40 30
disk_light 2 5 -2 1 0 -1 0 1 1 1
diffuse 0.8 0.7 0.6 0.1 0.1 0.1
sphere 1 0 0 -5
moving_object 0.5 0 0
sphere 50 0 -51 -5
)";

constexpr std::uint32_t many = most_rays_per_pixel;  // more than there is time for

class RefinerTest : public testing::Test {
 protected:
  RefinerTest() : refiner_(*usable_kernels().back(), 2, [this] { notified_++; }) {
    auto loaded = std::make_shared<LoadedScene>();
    loaded->path = "test.cli";
    loaded->scene = std::make_shared<const Scene>(test::scene_from(scene_text));
    loaded_ = loaded;
  }

  RefineTask task(std::uint32_t limit, const PictureOptions& options = {}) const {
    return {{}, loaded_, {options}, limit};
  }

  // Waits for news for which `condition` holds.
  template <typename Condition>
  RefinerNews wait(Condition&& condition) {
    return wait(refiner_, condition);
  }
  template <typename Condition>
  static RefinerNews wait(Refiner& refiner, Condition&& condition) {
    const auto end = std::chrono::steady_clock::now() + 120s;
    while (std::chrono::steady_clock::now() < end) {
      RefinerNews news = refiner.take();
      if (condition(news)) return news;
      std::this_thread::sleep_for(1ms);
    }
    ADD_FAILURE() << "timed out";
    return {};
  }
  // Only for tasks that stop at `rays`: others may be past it at the next look.
  std::shared_ptr<const Refinement> wait_for_rays(std::uint32_t rays) {
    return wait([rays](const RefinerNews& news) { return news.picture && news.picture->rays == rays; }).picture;
  }

  ZeroedVector<float> rendered(int rays, const PictureOptions& options = {}) const {
    Scene scene = with_options(*loaded_->scene, options);
    scene.settings.rays_per_pixel = rays;
    test::RenderSettings settings;
    settings.pattern = scene.settings.pattern;
    return test::render_scene(scene, settings).color;
  }

  std::atomic<int> notified_{0};
  std::shared_ptr<const LoadedScene> loaded_;
  Refiner refiner_;
};

TEST_F(RefinerTest, EveryPictureIsTheOneOfRender) {
  refiner_.show(task(20));
  std::vector<std::uint32_t> seen;
  wait([&](const RefinerNews& news) {
    if (!news.picture) return false;
    seen.push_back(news.picture->rays);
    EXPECT_EQ(news.picture->sides[0].image.rgb, rendered(static_cast<int>(seen.back()))) << seen.back() << " rays";
    return news.picture->done;
  });
  EXPECT_EQ(seen.back(), 20u);
  EXPECT_GT(notified_, 0);
}

TEST_F(RefinerTest, PatternsThatNeedTheCount) {
  PictureOptions options;
  options.sampler = Pattern::multijittered;
  refiner_.show(task(20, options));
  EXPECT_EQ(wait_for_rays(20)->sides[0].image.rgb, rendered(20, options));
}

TEST_F(RefinerTest, ALaterTaskTakesTheWorld) {
  refiner_.show(task(2));
  wait_for_rays(2);
  PictureOptions options;
  options.without.add(Effect::motion);
  options.disk_radius = {{0, 0.2}};
  refiner_.show(task(2, options));
  EXPECT_EQ(wait_for_rays(2)->sides[0].image.rgb, rendered(2, options));
  refiner_.show(task(2));
  EXPECT_EQ(wait_for_rays(2)->sides[0].image.rgb, rendered(2)) << "the narrower world would not do";
}

TEST_F(RefinerTest, AnEyeFarAwayHasAWorldOfItsOwn) {
  refiner_.show(task(2));
  wait_for_rays(2);
  PictureOptions options;
  options.eye = {300, 0, 95.5};
  options.uvw = {{0.3, 0, -0.95}, {0, 1, 0}, {0.95, 0, 0.3}};
  refiner_.show(task(2, options));
  EXPECT_EQ(wait_for_rays(2)->sides[0].image.rgb, rendered(2, options));
}

TEST_F(RefinerTest, WithoutALimitItRestsAtTheScenesOwn) {
  const test::TestFolder folder;
  test::put_content(folder / "own.cli", scene_text + "rays_per_pixel 6\n");
  refiner_.show({folder / "own.cli", nullptr, {{}}, 0});
  EXPECT_EQ(wait([](const RefinerNews& news) { return news.picture && news.picture->done; }).picture->rays, 6u);
}

TEST_F(RefinerTest, OldPicturesAreNotSeenAgain) {
  std::uint64_t last = 0;
  for (int i = 0; i < 50; i++) {
    PictureOptions options;
    options.seed = static_cast<std::uint32_t>(i);
    last = refiner_.show(task(many, options));
    const RefinerNews news = refiner_.take();
    if (news.picture) {
      EXPECT_EQ(news.picture->task, last);
    }
  }
  wait([last](const RefinerNews& news) { return news.picture && news.picture->task == last; });
}

TEST_F(RefinerTest, PauseHoldsAfterTheFirstPicture) {
  refiner_.pause(true);
  refiner_.show(task(many));
  const auto first = wait([](const RefinerNews& news) { return news.picture != nullptr; }).picture;
  EXPECT_EQ(first->rays, 1u);
  // Another refiner, which is not paused, reaches 64 rays meanwhile: long enough for a second picture if there were
  // one.
  Refiner other(*usable_kernels().back(), 2, [] {});
  other.show(task(many));
  wait(other, [](const RefinerNews& news) { return news.picture && news.picture->rays >= 64; });
  EXPECT_EQ(notified_, 1);
  EXPECT_EQ(refiner_.take().picture, nullptr);
  refiner_.pause(false);
  wait([](const RefinerNews& news) { return news.picture && news.picture->rays >= 4; });
}

TEST_F(RefinerTest, AStoppedPassLeavesNothing) {
  refiner_.show(task(many));
  int stops = 0;
  const auto picture = wait([&](const RefinerNews& news) {
                         if (stops == 30) return news.picture && news.picture->rays >= 64;
                         stops++;
                         refiner_.pause(true);  // the pass stops, and the next one may begin
                         refiner_.pause(false);
                         return false;
                       }).picture;
  EXPECT_EQ(picture->sides[0].image.rgb, rendered(static_cast<int>(picture->rays)));
}

TEST_F(RefinerTest, ALimitThatRisesGoesOn) {
  const std::uint64_t number = refiner_.show(task(4));
  EXPECT_TRUE(wait_for_rays(4)->done);
  refiner_.set_limit(8);
  const auto picture = wait_for_rays(8);
  EXPECT_EQ(picture->task, number);
  EXPECT_EQ(picture->sides[0].image.rgb, rendered(8));
}

TEST_F(RefinerTest, ALimitThatFallsBeginsAgain) {
  refiner_.show(task(many));
  wait([](const RefinerNews& news) { return news.picture && news.picture->rays >= 32; });
  refiner_.set_limit(5);
  const auto picture = wait([](const RefinerNews& news) { return news.picture && news.picture->done; }).picture;
  EXPECT_EQ(picture->rays, 5u);
  EXPECT_EQ(picture->sides[0].image.rgb, rendered(5));
}

TEST_F(RefinerTest, ALimitThatIsReachedAlreadyIsTold) {
  refiner_.pause(true);
  refiner_.show(task(many));
  wait_for_rays(1);
  refiner_.set_limit(1);
  EXPECT_TRUE(wait_for_rays(1)->done);
}

TEST_F(RefinerTest, TwoSidesHaveEqualRays) {
  RefineTask both = task(8);
  both.sides.emplace_back();
  both.sides[1].sampler = Pattern::random;
  refiner_.show(both);
  const auto picture = wait_for_rays(8);
  ASSERT_EQ(picture->sides.size(), 2u);
  EXPECT_EQ(picture->sides[0].image.rgb, rendered(8));
  EXPECT_EQ(picture->sides[1].image.rgb, rendered(8, both.sides[1]));
}

TEST_F(RefinerTest, ReadsFilesAndSaysWhatIsWrongWithThem) {
  const test::TestFolder folder;
  test::put_content(folder / "good.cli", scene_text);
  test::put_content(folder / "bad.cli", "shpere 1 0 0 -5\n");
  refiner_.show({folder / "bad.cli", nullptr, {{}}, 1});
  const RefinerNews bad = wait([](const RefinerNews& news) { return news.loaded != nullptr; });
  EXPECT_EQ(bad.loaded->scene, nullptr);
  EXPECT_EQ(bad.loaded->diagnostics.size(), 1u);
  refiner_.show({folder / "good.cli", nullptr, {{}}, 1});
  const auto picture = wait([](const RefinerNews& news) { return news.picture != nullptr; }).picture;
  EXPECT_EQ(picture->sides[0].image.rgb, rendered(1));
}

// A tile that takes minutes cannot be stopped: the next picture does not wait for it.
TEST_F(RefinerTest, IsNotHeldUpByWhatCannotBeStopped) {
  PictureOptions endless;
  endless.shadow_rays = 65536;
  refiner_.show(task(many, endless));
  std::this_thread::sleep_for(20ms);
  for (int i = 0; i < 5; i++) refiner_.show(task(2));
  EXPECT_EQ(wait_for_rays(2)->sides[0].image.rgb, rendered(2));
}

TEST_F(RefinerTest, ClosesAtOnce) {
  refiner_.show(task(many));
  wait([](const RefinerNews& news) { return news.picture && news.picture->rays >= 16; });
  EXPECT_TRUE(refiner_.close(60s));
}

}  // namespace
}  // namespace penumbra
