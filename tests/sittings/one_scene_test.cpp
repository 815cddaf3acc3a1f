// All frames of an animation are of the files that were read first, whatever happens to these on the way.
#include <fmt/format.h>

#include <filesystem>

#include "app/render/scene_frames.hpp"
#include "base/atomic_file.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

namespace fs = std::filesystem;

class OneScene : public SittingTest {
 protected:
  OneScene() {
    put_content(path("mesh.obj"), mesh_);
    put_content(path("part.cli"), "sphere {1 + t} 0 0 -5\n");
    put_content(scene_, text_);
    options_.scene = scene_;
    options_.outputs = {path("out.png")};
    options_.frames = AnimationRange{0, 9, 1};
    options_.quiet = true;
  }

  // The message of going on from frame 2 to frame 3; empty if all is well.
  std::string error_after(const std::function<void()>& change) const {
    SceneFrames scenes(options_, true);
    EXPECT_EQ(scenes.check(), 0);
    for (int frame = 0; frame < 3; frame++) {
      scenes.go_to(frame);
      scenes.current_is_done();
    }
    change();
    try {
      scenes.go_to(3);
    } catch (const FileError& error) {
      EXPECT_EQ(error.exit_code, 65);
      return error.what();
    }
    return {};
  }

  const std::string mesh_ = "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n";
  const std::string text_ = "image_size 20 15\nlight 2 5 1 1 1 1\nread part.cli\nmesh mesh.obj\n";
  const std::string frames_done_ = "; 3 of 10 frames are done, the last one is 2";
  RenderOptions options_;
};

TEST_F(OneScene, StaysAsItWasReadFirst) {
  EXPECT_EQ(error_after([] {}), "");
  EXPECT_EQ(error_after([&] { put_content(scene_, text_); }), "") << "the content counts";
}

TEST_F(OneScene, NamesTheFileThatChangedAndTheFramesDone) {
  const auto changed = [this](const std::string& name) {
    return fmt::format("`{}` has changed since this command began{}", path(name), frames_done_);
  };
  EXPECT_EQ(error_after([&] { put_content(scene_, text_ + "sphere 1 0\n"); }), changed("scene.cli"));
  put_content(scene_, text_);
  EXPECT_EQ(error_after([&] { put_content(path("part.cli"), "sphere {2 + t} 0 0 -5\n"); }), changed("part.cli"));
  EXPECT_EQ(error_after([&] { put_content(path("mesh.obj"), mesh_ + "f 1 3 2\n"); }), changed("mesh.obj"));
  EXPECT_EQ(error_after([&] { put_content(path("mesh.obj"), ""); }), changed("mesh.obj"));
}

TEST_F(OneScene, NamesTheFileThatVanished) {
  EXPECT_EQ(error_after([&] { fs::remove(path("mesh.obj")); }),
            fmt::format("`{}` can no longer be read: No such file or directory{}", path("mesh.obj"), frames_done_));
  put_content(path("mesh.obj"), mesh_);
  EXPECT_EQ(error_after([&] { fs::remove(scene_); }),
            fmt::format("`{}` can no longer be read: No such file or directory{}", scene_, frames_done_));
}

// A scene without expressions is read once.
TEST_F(OneScene, ThatDoesNotVaryIsNotReadAgain) {
  put_content(path("part.cli"), "sphere 1 0 0 -5\nmoving_object 1 0 0\n");
  EXPECT_EQ(error_after([&] { fs::remove(scene_); }), "");
}

TEST_F(OneScene, EndsTheRenderWhenItChanges) {
  put_content(path("part.cli"), "rays_per_pixel {200 + frame}\nsphere 1 0 0 -5\n");
  RunningProgram program({"render", scene_, "--quiet", "--frames", "0-4000", "-o", path("out.png")}, log_);
  while (!fs::exists(path("out.0000.png"))) sleep_for(0.01);
  put_content(path("mesh.obj"), mesh_ + "# changed\n");
  EXPECT_EQ(program.wait(), 65);
  EXPECT_NE(said().find("mesh.obj` has changed since this command began; "), std::string::npos) << said();
  EXPECT_NE(said().find(" of 4001 frames are done, the last one is "), std::string::npos) << said();
}

}  // namespace
}  // namespace penumbra::test
