// Renders that are killed at random moments, without a chance to save, and resumed: the final file is that of an
// unbroken render, byte for byte, and nothing else is left.
#include <gtest/gtest.h>

#include <random>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

const Words layers = {"--aov", "depth,normal,albedo,variance,samples"};

class Kill : public SittingTest {
 protected:
  void SetUp() override {
    SittingTest::SetUp();
    if (scaled(1, 0) == 0) GTEST_SKIP() << "under a sanitizer, so many renders take minutes";
  }

  // Kills a render `kills` times at random moments of its first `seconds`, then lets it end.
  void kill_and_resume(const Words& arguments, int kills, double seconds, std::mt19937& random) const {
    const Words command =
        Words{"render", scene_, "--quiet", "--threads", "2", "-o", picture_, "--checkpoint", checkpoint_, "--resume"} +
        arguments;
    for (int i = 0; i < kills; i++) {
      RunningProgram program(command, log_);
      sleep_for(std::uniform_real_distribution<double>(0, seconds)(random));
      program.send(SIGKILL);
      const int code = program.wait();
      ASSERT_TRUE(code == 128 + SIGKILL || code == 0) << code << said();
    }
    ASSERT_EQ(run(command), 0) << said();
  }

  void equal_files(int times, const Words& arguments) const {
    std::mt19937 random(5);
    const auto [whole, seconds] = unbroken(arguments);
    for (int i = 0; i < times; i++) {
      kill_and_resume(arguments + Words{"--every", "0.03s"}, 1 + i % 4, seconds, random);
      ASSERT_TRUE(content_of(picture_) == whole) << i;
      ASSERT_EQ(others(), Words{"picture.exr"}) << i;
      std::filesystem::remove(picture_);
    }
  }

  // Checkpoints are large and saved all the time, so that most kills come while one is being written.
  void kills_while_writing(int kills) const {
    std::mt19937 random(6);
    const Words arguments = Words{"--size", "400x300", "--rays", "16"} + layers;
    const auto [whole, seconds] = unbroken(arguments);
    for (int done = 0; done < kills; done += 10) {
      kill_and_resume(arguments + Words{"--every", "0.001s"}, 10, seconds, random);
      ASSERT_TRUE(content_of(picture_) == whole) << done;
      ASSERT_EQ(others(), Words{"picture.exr"}) << done;
    }
  }
};

const Words uniform = Words{"--rays", std::to_string(scaled(128, 32))} + layers;
const Words adaptive = Words{"--noise", scaled(1, 0) ? "0.015" : "0.06"} + layers;
const Words cropped = Words{"--noise", scaled(1, 0) ? "0.01" : "0.05", "--crop", "5,7,39,30"} + layers;

TEST_F(Kill, UniformEqualFiles) { equal_files(4, uniform); }
TEST_F(Kill, AdaptiveEqualFiles) { equal_files(3, adaptive); }
TEST_F(Kill, CroppedEqualFiles) { equal_files(3, cropped); }
TEST_F(Kill, WhileFilesAreWritten) { kills_while_writing(20); }

// `make test-long` runs these too.
TEST_F(Kill, DISABLED_ManyUniformEqualFiles) { equal_files(80, uniform); }
TEST_F(Kill, DISABLED_ManyAdaptiveEqualFiles) { equal_files(60, adaptive); }
TEST_F(Kill, DISABLED_ManyCroppedEqualFiles) { equal_files(60, cropped); }
TEST_F(Kill, DISABLED_ManyWhileFilesAreWritten) { kills_while_writing(500); }

}  // namespace
}  // namespace penumbra::test
