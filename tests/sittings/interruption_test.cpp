// Signals and the time limit: the picture so far and the checkpoint are written, the exit code is 75, and resuming
// gives the file of an unbroken render.
#include "app/sessions/interruption.hpp"

#include <gtest/gtest.h>

#include "image/image_file.hpp"
#include "rendering/checkpoint.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

// How a child process that does `work` ends: its exit code, or 128 plus the number of the signal.
template <class Work>
int end_of_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(Interruption, TheFirstSignalSetsTheFlagTheSecondEnds) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int end = end_of_child([signal] {
      std::atomic<bool> flag{false};
      Interruption interruption(std::nullopt);
      interruption.stop_through(flag);
      if (interruption.signal()) ::_exit(1);
      ::raise(signal);
      if (!flag || !interruption.signal()) ::_exit(2);
      ::raise(SIGTERM);
      ::_exit(3);
    });
    EXPECT_EQ(end, 128 + SIGTERM) << signal;
  }
}

TEST(Interruption, WithNothingToSaveTheFirstEnds) {
  const int end = end_of_child([] {
    const Interruption interruption(std::nullopt);
    ::close(STDERR_FILENO);
    ::raise(SIGINT);
  });
  EXPECT_EQ(end, 75);
}

TEST(Interruption, IsNotedBetweenPictures) {
  const int end = end_of_child([] {
    std::atomic<bool> flag{false};
    Interruption interruption(std::nullopt);
    interruption.only_note();
    ::raise(SIGINT);
    if (flag) ::_exit(1);
    interruption.stop_through(flag);
    ::_exit(flag ? 42 : 2);
  });
  EXPECT_EQ(end, 42);
}

TEST(Interruption, ThatWasNotedEndsWhatHasNothingToLose) {
  const int end = end_of_child([] {
    Interruption interruption(std::nullopt);
    interruption.only_note();
    ::raise(SIGINT);
    interruption.end_soon();
    while (true) ::pause();
  });
  EXPECT_EQ(end, 75);
}

TEST(Interruption, ComesWhenTheTimeIsUp) {
  const int end = end_of_child([] {
    std::atomic<bool> flag{false};
    Interruption interruption(std::chrono::steady_clock::now() + std::chrono::milliseconds(50));
    interruption.stop_through(flag);
    while (!flag) sleep_for(0.01);
    ::_exit(interruption.signal() ? 1 : 42);  // nobody else has asked
  });
  EXPECT_EQ(end, 42);
}

TEST(Interruption, OfTimeThatIsUpAlreadyEndsWhatHasNothingToLose) {
  const int end = end_of_child([] {
    const Interruption interruption(std::chrono::steady_clock::now());
    while (true) ::pause();
  });
  EXPECT_EQ(end, 75);
}

class Interrupted : public SittingTest {
 protected:
  // A render that takes minutes.
  Words endless() const {
    return Words{"render", scene_,   "--size",       "640x480",   "--rays",  "100000", "--threads",  "2",
                 "-o",     picture_, "--checkpoint", checkpoint_, "--every", "0.2s",   "--progress", "none"};
  }
};

TEST_F(Interrupted, BySignals) {
  for (const int signal : {SIGTERM, SIGINT}) {
    RunningProgram program(endless(), log_);
    while (!std::filesystem::exists(checkpoint_)) sleep_for(0.01);
    const auto start = std::chrono::steady_clock::now();
    program.send(signal);
    EXPECT_EQ(program.wait(), 75) << said();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 20) << "at once, if not in the two seconds of an idle machine";
    EXPECT_NE(said().find(signal == SIGINT ? "interrupted by SIGINT" : "interrupted by SIGTERM"), std::string::npos)
        << said();
    EXPECT_EQ(read_image(picture_).image.width, 640);
    EXPECT_TRUE(read_last_checkpoint(checkpoint_).checkpoint);
    std::filesystem::remove(checkpoint_);
    std::filesystem::remove(picture_);
  }
}

TEST_F(Interrupted, ByTheTimeLimit) {
  const Words arguments = {"--rays", std::to_string(scaled(512, 64)), "--aov", "depth,samples"};
  const auto [whole, seconds] = unbroken(arguments);
  const Words limited =
      arguments +
      Words{"--checkpoint", checkpoint_, "--resume", "--time-limit", std::to_string(seconds / 3) + "s", "-o", picture_};
  int sittings = 1;
  for (int code; (code = render(limited)) != 0; sittings++) {
    ASSERT_EQ(code, 75) << said();
    EXPECT_EQ(said(), "penumbra: the time limit is reached: the same command with --resume continues from `" +
                          checkpoint_ + "`\n");
    ASSERT_LT(sittings, 200);
  }
  EXPECT_GT(sittings, 1);
  EXPECT_TRUE(content_of(picture_) == whole);
  EXPECT_EQ(others(), Words{"picture.exr"});
}

TEST_F(Interrupted, WithoutACheckpointThereIsThePicture) {
  EXPECT_EQ(render({"--rays", "1000000", "--time-limit", "0.5", "-o", picture_}), 75);
  EXPECT_EQ(said(), "penumbra: the time limit is reached: the picture is not finished\n");
  EXPECT_EQ(read_image(picture_).image.width, 53);
}

// Whatever one sample costs, a render ends: these would take hours, or forever.
TEST_F(Interrupted, WithinASample) {
  std::string shells = "eye 0 0 9\nlight 0 9 0 1 1 1\nmax_depth 100\nshiny 0 0 0 0 0 0 0 0 0 1 .5 .5 1.5\n";
  for (int i = 0; i < 100; i++) shells += fmt::format("sphere {} 0 0 0\n", 1 + 0.05 * i);
  std::string nest = "eye 0 0 9\nlight 0 9 0 1 1 1\ndiffuse .5 .5 .5 .1 .1 .1\nsphere 2 0 0 0\nnamed_object o0\n";
  for (int level = 1; level <= 8; level++) {
    nest += "begin_list\n";
    for (int i = 0; i < 30; i++) {
      nest += "push\ntranslate " + std::to_string(0.001 * i) + " 0 0\nrotatey " + std::to_string(12 * i) +
              "\ninstance o" + std::to_string(level - 1) + "\npop\n";
    }
    nest += "end_list\nnamed_object o" + std::to_string(level) + "\n";
  }
  nest += "instance o8\n";
  const Words most = {"--rays", "4096", "--shadow-rays", "65536", "--reflection-rays", "65536", "--transmission-rays",
                      "65536"};
  const std::pair<std::string, Words> scenes[] = {{shells, {}}, {nest, {}}, {scene_text(16), most}};
  for (const auto& [text, options] : scenes) {
    put_content(scene_, text);
    EXPECT_EQ(render(options + Words{"--time-limit", "0.5s", "-o", picture_}), 75) << said();
  }
}

// An unfinished shard writes no part.
TEST_F(Interrupted, AShardHasItsCheckpointOnly) {
  EXPECT_EQ(render({"--rays", "1000000", "--time-limit", "0.5", "-o", picture_, "--shard", "0/2", "--checkpoint",
                    checkpoint_}),
            75);
  EXPECT_EQ(others(), Words{"checkpoint"});
}

}  // namespace
}  // namespace penumbra::test
