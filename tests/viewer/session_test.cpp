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
  wait_until_done();
  EXPECT_EQ(session.picture()->rays, 3u) << "it rests at what the scene says";
  EXPECT_EQ(session.limit(), 3u);
  EXPECT_EQ(session.changed_lines(), "");
  execute(ViewCommandKind::more_rays);
  EXPECT_EQ(session.limit(), 6u) << "twice what the scene says";
  execute(ViewCommandKind::fewer_rays);
  execute(ViewCommandKind::fewer_rays);
  EXPECT_EQ(session.limit(), 1u);
  execute(ViewCommandKind::fewer_rays);
  EXPECT_EQ(session.limit(), 1u);
  wait([](const Session& s) { return s.picture()->done && s.picture()->rays == 1; });
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

TEST_F(SessionTest, ANewSceneStartsUnpausedAtExposureZero) {
  test::put_content(folder_ / "s02a.cli", scene_text);
  Session& session = open();
  wait_until_done();
  execute(ViewCommandKind::pause);
  execute(ViewCommandKind::brighter);
  session.execute({ViewCommandKind::load_scene, 2, false}, {});
  EXPECT_FALSE(session.paused());
  EXPECT_EQ(session.exposure_halves(), 0);
  wait_until_done();
  EXPECT_EQ(session.picture()->rays, 4u);
}

TEST_F(SessionTest, EscapeClosesWhatIsOpenFirst) {
  Session& session = open();
  wait_until_done();
  session.inspect_at({200, 150});
  execute(ViewCommandKind::camera);
  execute(ViewCommandKind::help);
  execute(ViewCommandKind::escape);
  EXPECT_FALSE(session.help());
  EXPECT_TRUE(session.inspection());
  execute(ViewCommandKind::escape);
  EXPECT_FALSE(session.inspection());
  EXPECT_TRUE(session.moves_camera());
  execute(ViewCommandKind::escape);
  EXPECT_FALSE(session.moves_camera());
  EXPECT_FALSE(session.wants_to_quit());
  execute(ViewCommandKind::escape);
  EXPECT_TRUE(session.wants_to_quit());
}

TEST_F(SessionTest, TheScenesOfAFolderFollowEachOther) {
  std::filesystem::remove(folder_ / "s01a.cli");
  test::put_content(folder_ / "ant.cli", scene_text);
  test::put_content(folder_ / "bee.cli", scene_text);
  Session& session = open();
  EXPECT_EQ(session.path().filename(), "ant.cli");
  EXPECT_EQ(session.scenes().size(), 2u);
  session.execute({ViewCommandKind::next_scene, 1}, {});
  EXPECT_EQ(session.path().filename(), "bee.cli");
  session.execute({ViewCommandKind::next_scene, 1}, {});
  EXPECT_EQ(session.path().filename(), "ant.cli");
  session.execute({ViewCommandKind::next_scene, -1}, {});
  EXPECT_EQ(session.path().filename(), "bee.cli");
}

TEST_F(SessionTest, LightsAndSurfacesAreNamedByLineAndKind) {
  test::put_content(folder_ / "lamps.cli", "\npoint_light 0 5 0 1 1 1\n");
  test::put_content(folder_ / "s01a.cli",
                    scene_text + "read lamps.cli\nsphere 1 3 0 -5\ndiffuse 1 0 0 0 0 0\n\nsphere 1 4 0 -5\n");
  Session& session = open();
  wait_until_done();
  EXPECT_EQ(session.name_of_light(1), "line 4, disk_light");
  EXPECT_EQ(session.name_of_light(2), (folder_ / "lamps.cli").string() + " line 2, point_light");
  EXPECT_EQ(session.name_of_surface(1), "line 5, glossy");
  EXPECT_EQ(session.name_of_surface(2), "line 9, diffuse");
}

TEST_F(SessionTest, FocusIsWrittenAsPeopleWriteIt) {
  test::put_content(folder_ / "s01a.cli", "image_size 40 30\ncamera_lens 0.1 1.4 5\nsphere 1 0.3 0.2 -16.0491\n");
  Session& session = open();
  wait_until_done();
  execute(ViewCommandKind::focus);
  const std::string lines = session.changed_lines();
  EXPECT_EQ(lines.substr(lines.find("lens")), "lens 0.0357143 15.18\n");
}

TEST_F(SessionTest, WarningsAreKept) {
  test::put_content(folder_ / "s01a.cli", "image_size 40 30\nsphere 1 0 0 -5\n");
  Session& session = open();
  wait_until_done();
  ASSERT_EQ(session.warnings().size(), 1u);
  EXPECT_EQ(session.warnings()[0].message, "there is no light in this picture");
}

class CameraTest : public SessionTest {
 protected:
  // Turns the camera by a drag and waits for the picture.
  void drag(void (Session::*how)(double, double), double right, double down) {
    session_->take_hold({200, 150});
    ((*session_).*how)(right, down);
    wait([](const Session& s) { return s.picture_is_current() && s.picture()->done && s.camera_lines() != ""; });
  }
  // The scene with the copied lines gives the camera that is shown.
  void expect_lines_to_repeat_the_camera() {
    const Camera shown = session_->picture()->sides[0].scene->camera;
    test::put_content(folder_ / "again.cli", scene_text + session_->changed_lines());
    const LoadedScene again = load_scene(folder_ / "again.cli", {});
    ASSERT_TRUE(again.scene);
    EXPECT_EQ(pose_of(again.scene->camera), pose_of(shown));
    EXPECT_TRUE(again.diagnostics.empty()) << to_string(again.diagnostics.front());
    EXPECT_LE(session_->camera_lines().size(), 125u) << "too many digits: " << session_->camera_lines();
  }
};

TEST_F(CameraTest, TurnsRoundWhatIsHeld) {
  Session& session = open();
  wait_until_done();
  drag(&Session::turn_camera, 60, 20);
  const Camera& camera = session.picture()->sides[0].scene->camera;
  EXPECT_NEAR(length(camera.eye - Vec3{0, 0, -4}), 4, 0.01) << "as far from the front of the ball as before";
  EXPECT_LT(camera.eye.x, 0) << "the ball seems to turn to the right";
  EXPECT_GT(camera.eye.y, 0) << "and down";
  EXPECT_NEAR(dot(normalize(Vec3{0, 0, -4} - camera.eye), -camera.back), 1, 1e-3) << "and stays in the middle";
  expect_lines_to_repeat_the_camera();
}

TEST_F(CameraTest, MovesAndComesNearer) {
  Session& session = open();
  wait_until_done();
  drag(&Session::move_camera, 40, 0);
  EXPECT_EQ(session.camera_lines().find("uvw"), std::string::npos) << session.camera_lines();
  EXPECT_LT(session.picture()->sides[0].scene->camera.eye.x, 0);
  expect_lines_to_repeat_the_camera();
  session.forget_changes();
  wait_until_done();
  session.bring_camera_nearer(1, {200, 150});
  session.bring_camera_nearer(1, {200, 150});
  wait([](const Session& s) { return s.picture_is_current() && s.picture()->done && s.camera_lines() != ""; });
  EXPECT_NEAR(session.picture()->sides[0].scene->camera.eye.z, -4 + 4 * 0.81, 0.01);
  expect_lines_to_repeat_the_camera();
}

}  // namespace
}  // namespace penumbra
