#include "viewer/session.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "base/test_folder.hpp"
#include "image/image_file.hpp"
#include "rendering/isa.hpp"

namespace penumbra {
namespace {

using namespace std::chrono_literals;

const std::string scene_text = R"(image_size 40 30
rays_per_pixel 3
lens 0.1 5
disk_light 2 5 -2 1 0 -1 0 1 1 1
glossy 0.8 0.7 0.6 0.1 0.1 0.1 10 0.3 0.1
sphere 1 0 0 -5
)";

class SessionTest : public testing::Test {
 protected:
  SessionTest() { test::put_content(folder_ / "s01a.cli", scene_text); }

  Session& open(std::optional<int> rays = 4) {
    SessionOptions options;
    options.given = folder_.path();
    options.save_folder = folder_.path();
    options.threads = 2;
    options.kernel = usable_kernels().back();
    options.picture.rays = rays;
    session_.emplace(options, [] {});
    session_->view().set_area({0, 0, 400, 300});
    return *session_;
  }

  template <typename Condition>
  void wait(Condition&& condition) {
    const auto end = std::chrono::steady_clock::now() + 120s;
    while (std::chrono::steady_clock::now() < end) {
      session_->poll();
      if (condition(*session_)) return;
      std::this_thread::sleep_for(1ms);
    }
    FAIL() << "timed out";
  }
  void wait_until_done() {
    wait([](const Session& s) { return s.picture_is_current() && s.picture()->done; });
  }
  void execute(ViewCommandKind kind) { session_->execute({kind}, {200, 150}); }

  test::TestFolder folder_;
  std::optional<Session> session_;
};

TEST_F(SessionTest, RaysAreDoubledAndHalved) {
  Session& session = open(std::nullopt);
  wait([](const Session& s) { return s.picture_is_current(); });
  EXPECT_EQ(session.limit(), 0u);
  execute(ViewCommandKind::more_rays);
  EXPECT_EQ(session.limit(), 6u) << "twice what the scene says";
  execute(ViewCommandKind::fewer_rays);
  execute(ViewCommandKind::fewer_rays);
  EXPECT_EQ(session.limit(), 1u);
  execute(ViewCommandKind::fewer_rays);
  EXPECT_EQ(session.limit(), 1u);
  wait_until_done();
  EXPECT_EQ(session.picture()->rays, 1u);
}

TEST_F(SessionTest, WarningsOfTheSceneAreShown) {
  const std::string blurred = "image_size 8 6\nlight 0 9 0 1 1 1\nlens 0.1 4\nsphere 1 0 0 -4\n";
  test::put_content(folder_ / "s01a.cli", blurred);
  open(std::nullopt);
  wait([](const Session& s) { return s.picture_is_current(); });
  const std::string said = session_->message();
  EXPECT_NE(said.find("s01a.cli:3:1: warning: the blur of a lens with one ray"), std::string::npos) << said;
  EXPECT_EQ(session_->error(), "");
  test::put_content(folder_ / "s01a.cli", blurred + "diffuse 255 0 0 0 0 0\n" + "push\n");
  execute(ViewCommandKind::restart);
  wait([](const Session& s) { return s.message().find("and 2 more") != std::string::npos; });
  open(4);
  wait([](const Session& s) { return s.picture_is_current(); });
  EXPECT_NE(session_->message().find("and 1 more"), std::string::npos) << "four rays are enough";
}

TEST_F(SessionTest, AnotherSceneForgetsWhatWasChanged) {
  test::put_content(folder_ / "s02a.cli", scene_text);
  Session& session = open();
  wait_until_done();
  session.change([](PictureOptions& o) { o.lens = {0.4, 7}; });
  session.change_side(0, [](PictureOptions& o) { o.without.toggle(Effect::gloss); });
  EXPECT_EQ(session.scene_with_all_effects().camera.lens_radius, 0.4);
  session.execute({ViewCommandKind::load_scene, 2, false}, {});
  wait_until_done();
  EXPECT_EQ(session.scene_with_all_effects().camera.lens_radius, 0.1);
  EXPECT_TRUE(session.options(0).without.empty());
  EXPECT_EQ(session.limit(), 4u) << "the command line is not forgotten";
}

TEST_F(SessionTest, ALightThatIsGoneIsForgotten) {
  Session& session = open();
  wait_until_done();
  session.change([](PictureOptions& o) { o.disk_radius = {{1, 0.3}}; });
  test::put_content(folder_ / "s01a.cli", "image_size 40 30\npoint_light 0 5 0 1 1 1\nsphere 1 0 0 -5\n");
  wait([](const Session& s) {
    return s.scene() && s.scene()->settings.width == 40 && std::holds_alternative<PointLight>(s.scene()->lights[0]);
  });
  test::put_content(folder_ / "s01a.cli", "image_size 40 30\nsphere 1 0 0 -5\n");
  wait([](const Session& s) { return s.scene() && s.scene()->lights.empty(); });
  EXPECT_TRUE(session.options(0).disk_radius.empty());
}

TEST_F(SessionTest, FocusIsPutWhereTheCursorIs) {
  Session& session = open();
  wait_until_done();
  execute(ViewCommandKind::focus);
  EXPECT_NEAR(session.scene_with_all_effects().camera.focus_distance, 4, 0.01);
  EXPECT_EQ(session.scene_with_all_effects().camera.lens_radius, 0.1);
  wait_until_done();
  EXPECT_NEAR(session.picture()->sides[0].scene->camera.focus_distance, 4, 0.01);
}

TEST_F(SessionTest, TheSplitViewComparesTwoSamplers) {
  Session& session = open();
  wait_until_done();
  execute(ViewCommandKind::split);
  wait([](const Session& s) { return s.picture_is_current() && s.picture()->done && s.picture()->sides.size() == 2; });
  EXPECT_EQ(session.sampler(0), default_pattern);
  EXPECT_EQ(session.sampler(1), Pattern::random);
  session.execute({ViewCommandKind::toggle_effect, 0, false, Effect::lens}, {});
  EXPECT_TRUE(session.options(0).without.empty());
  EXPECT_TRUE(session.options(1).without.has(Effect::lens));
  wait_until_done();
  execute(ViewCommandKind::save);
  EXPECT_EQ(session.message(), "saved s01a-view-left.png and s01a-view-right.png with 4 rays per pixel");
  const ImageFile right = read_image(folder_ / "s01a-view-right.png");
  EXPECT_NE(
      std::find(right.metadata.begin(), right.metadata.end(), std::pair<std::string, std::string>("without", "lens")),
      right.metadata.end());
}

TEST_F(SessionTest, AFolderThatCannotBeWrittenIsSaid) {
  SessionOptions options;
  options.given = folder_.path();
  options.save_folder = folder_ / "missing";
  options.kernel = usable_kernels().back();
  options.picture.rays = 1;
  session_.emplace(options, [] {});
  wait_until_done();
  execute(ViewCommandKind::save);
  EXPECT_NE(session_->message().find("missing"), std::string::npos) << session_->message();
}

TEST_F(SessionTest, PausedEditsShowTheirFirstPicture) {
  Session& session = open(std::nullopt);
  wait([](const Session& s) { return s.picture_is_current() && s.picture()->rays >= 2; });
  execute(ViewCommandKind::pause);
  session.change([](PictureOptions& o) { o.lens = {0.3, 4}; });
  wait([](const Session& s) { return s.picture_is_current(); });
  EXPECT_EQ(session.picture()->rays, 1u);
}

}  // namespace
}  // namespace penumbra
