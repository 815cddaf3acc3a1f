// A checkpoint that cannot be written does not cost the picture, and two runs do not share one.
#include <filesystem>

#include "base/file_lock.hpp"
#include "rendering/checkpoint.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

namespace fs = std::filesystem;

class LostCheckpoint : public SittingTest {
 protected:
  LostCheckpoint() { fs::create_directory(path("place")); }

  Words command(const Words& more) const {
    return Words{"render", scene_, "--quiet", "--every", "0.02s", "--checkpoint", inner_, "-o", picture_} + more;
  }
  // Takes the checkpoint's folder away as soon as there is a checkpoint in it, or the program ends.
  void lose_place(const RunningProgram& program) const {
    while (!fs::exists(inner_) && program.is_running()) sleep_for(0.005);
    fs::rename(path("place"), path("elsewhere"));
  }

  const std::string inner_ = path("place/checkpoint");
};

TEST_F(LostCheckpoint, DoesNotCostThePicture) {
  const Words arguments = {"--rays", std::to_string(scaled(3000, 300))};
  const std::string whole = unbroken(arguments).first;
  RunningProgram program(command(arguments), log_);
  lose_place(program);
  EXPECT_EQ(program.wait(), 0) << said();
  EXPECT_TRUE(content_of(picture_) == whole);
}

TEST_F(LostCheckpoint, IsReportedWhenTheRenderIsInterrupted) {
  RunningProgram program(command({"--rays", "1000000"}), log_);
  lose_place(program);
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(), 73) << said();
  EXPECT_TRUE(said().starts_with("penumbra: warning: the checkpoint `" + inner_ + "` cannot be saved")) << said();
  EXPECT_EQ(said().find("warning", 20), std::string::npos) << "once in a row: " << said();
  EXPECT_NE(said().find("interrupted by SIGTERM: the picture is not finished\n"), std::string::npos) << said();
  EXPECT_TRUE(fs::exists(picture_));
}

TEST_F(LostCheckpoint, IsTriedAgain) {
  RunningProgram program(command({"--rays", "1000000"}), log_);
  lose_place(program);
  while (said().empty()) sleep_for(0.005);
  fs::create_directory(path("place"));
  while (!fs::exists(inner_)) sleep_for(0.005);
  program.send(SIGTERM);
  EXPECT_EQ(program.wait(), 75) << said();
  EXPECT_TRUE(read_last_checkpoint(inner_).checkpoint);
}

TEST_F(LostCheckpoint, IsNotTakenFromAnotherRun) {
  fs::create_symlink("place/checkpoint", path("link"));
  {
    const FileLock other(inner_, "");
    EXPECT_EQ(run(command({})), 73);
    EXPECT_EQ(said(), "penumbra: another run writes the checkpoint `" + inner_ +
                          "`: wait for its end, or choose another file with --checkpoint\n");
    EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("link"), "--resume"}), 73) << said();
    EXPECT_FALSE(fs::exists(picture_));
  }
  EXPECT_EQ(run(command({})), 0) << said();
  EXPECT_TRUE(fs::is_empty(path("place")));
}

TEST_F(LostCheckpoint, IsNotTakenFromARunningProgram) {
  RunningProgram first(command({"--rays", "1000000"}), path("other-log"));
  while (!fs::exists(inner_)) sleep_for(0.005);
  EXPECT_EQ(run(command({"--rays", "1000000"})), 73) << said();
  first.send(SIGKILL);
  first.wait();
  EXPECT_EQ(run(command({"--rays", "1000000", "--resume", "--time-limit", "0.01s"})), 75) << said();
}

}  // namespace
}  // namespace penumbra::test
