// Whichever call that writes a file fails, and however: a message and the exit code say so, the old file is untouched,
// no temporary file is left, the picture is in another file if any can be written, and the render can be resumed.
#include <gtest/gtest.h>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

class FailingCall : public SittingTest {
 protected:
  // Exit code and name of the call that failed; no name if there are fewer calls.
  std::pair<int, std::string> run_with_failure(const Words& command, int call, const std::string& how) const {
    std::filesystem::remove(path("failed"));
    const int code = run(command, {{"LD_PRELOAD", PENUMBRA_FAILING_CALLS},
                                   {"ASAN_OPTIONS", "verify_asan_link_order=0"},
                                   {"PENUMBRA_FAIL", std::to_string(call) + ":" + how},
                                   {"PENUMBRA_FAIL_LOG", path("failed")}});
    const std::string failed = content_of(path("failed"));
    std::filesystem::remove(path("failed"));
    return {code, failed};
  }

  // Runs the command once for each call, with that call failing. Before each run, `prepare()` puts the files in place;
  // after it, `check` gets the exit code and the call's name.
  template <class Prepare, class Check>
  void for_every_call(const Words& command, int fewest_calls, const Prepare& prepare, const Check& check) const {
    for (const std::string how : {"ENOSPC", "EIO", "SHORT", "FULL"}) {
      for (int call = 1;; call++) {
        prepare();
        const auto [code, failed] = run_with_failure(command, call, how);
        if (failed.empty()) {
          EXPECT_GT(call, how == "SHORT" || how == "FULL" ? 1 : fewest_calls) << how;
          break;
        }
        SCOPED_TRACE(how + " in call " + std::to_string(call) + ", " + failed);
        check(code, failed, how);
      }
    }
  }
};

TEST_F(FailingCall, OfARender) {
  const std::string picture = unbroken({}).first;
  for_every_call(
      {"render", scene_, "--quiet", "-o", picture_}, 3, [&] { put_content(picture_, "old"); },
      [&](int code, const std::string& failed, const std::string& how) {
        const bool harmless = how == "SHORT";
        EXPECT_EQ(code, harmless ? 0 : failed == "rename" ? 73 : 74);
        EXPECT_EQ(content_of(picture_) == picture, harmless);
        EXPECT_EQ(content_of(picture_) == "old", !harmless);
        EXPECT_EQ(said().starts_with("penumbra: cannot "), !harmless) << said();
        const bool is_rescued = how == "ENOSPC" || how == "EIO";  // this call fails, and no other
        EXPECT_EQ(content_of(path("picture.rescued.exr")) == picture, is_rescued);
        EXPECT_EQ(said().find("; it is in `" + path("picture.rescued.exr") + "` instead\n") != said().npos, is_rescued);
        std::filesystem::remove(path("picture.rescued.exr"));
        EXPECT_EQ(others(), Words{"picture.exr"});
      });
}

TEST_F(FailingCall, LeavesWhatItFindsBesideThePicture) {
  const std::string picture = unbroken({}).first;
  put_content(path("picture.rescued.exr"), "mine");
  EXPECT_EQ(run_with_failure({"render", scene_, "--quiet", "-o", picture_}, 1, "EIO").first, 74);
  EXPECT_EQ(content_of(path("picture.rescued.exr")), "mine");
  EXPECT_TRUE(content_of(path("picture.rescued-2.exr")) == picture);
}

// The checkpoint is removed once the picture is written, so the picture's name has to be on the disk by then.
TEST_F(FailingCall, PictureOfACheckpointIsForcedToTheDiskWithItsFolder) {
  Words calls;
  for (int call = 1;; call++) {
    const auto [code, failed] =
        run_with_failure({"render", scene_, "--quiet", "-o", picture_, "--checkpoint", checkpoint_}, call, "EIO");
    if (failed.empty()) break;
    EXPECT_EQ(code == 0, failed == "fsync of a folder") << failed;
    calls.push_back(failed);
  }
  EXPECT_EQ(calls, (Words{"write", "fsync", "rename", "fsync of a folder"}));
}

TEST_F(FailingCall, OfAMerge) {
  const Words parts = {path("part0"), path("part1")};
  const std::string picture = unbroken({}).first;
  for (const std::string index : {"0", "1"}) {
    ASSERT_EQ(render({"--shard", index + "/2", "-o", path("part" + index + ".exr")}), 0) << said();
  }
  for_every_call(
      {"merge", "--quiet", path("part0.exr"), path("part1.exr"), "-o", picture_}, 4,
      [&] { put_content(picture_, "old"); },
      [&](int code, const std::string& failed, const std::string& how) {
        const bool harmless = how == "SHORT" || failed == "fsync of a folder";
        EXPECT_EQ(code, harmless ? 0 : failed == "rename" ? 73 : 74);
        EXPECT_EQ(content_of(picture_) == picture, harmless);
        EXPECT_EQ(said().starts_with("penumbra: cannot "), !harmless) << said();
        EXPECT_EQ(others(), (Words{"part0.exr", "part1.exr", "picture.exr"}));
      });
}

TEST_F(FailingCall, OfASittingThatIsInterrupted) {
  const Words arguments = {"--rays", std::to_string(scaled(200, 40))};
  const auto [picture, seconds] = unbroken(arguments);
  const Words sitting =
      Words{"render", scene_, "--quiet", "-o", picture_, "--checkpoint", checkpoint_, "--resume"} + arguments;
  ASSERT_EQ(run(sitting + Words{"--time-limit", std::to_string(seconds / 3)}), 75) << said();
  const std::string checkpoint = content_of(checkpoint_);
  for_every_call(
      sitting + Words{"--time-limit", "0.0001s"}, 10,
      [&, checkpoint = checkpoint] {
        put_content(picture_, "old");
        put_content(checkpoint_, checkpoint);
        put_content(checkpoint_ + ".previous", checkpoint);
      },
      [&, picture = picture](int code, const std::string& failed, const std::string& how) {
        if (code != 75) {
          EXPECT_TRUE(code == 73 || code == 74) << code << failed << how;
          const bool of_checkpoint = said().starts_with("penumbra: warning: the checkpoint ");
          EXPECT_TRUE(of_checkpoint || said().starts_with("penumbra: cannot ")) << said();
          EXPECT_EQ(content_of(picture_) == "old", !of_checkpoint || how == "FULL");
        }
        std::filesystem::remove(path("picture.rescued.exr"));
        EXPECT_EQ(others(), (Words{"checkpoint", "checkpoint.previous", "picture.exr"}));
        EXPECT_EQ(run(sitting), 0) << said();
        EXPECT_TRUE(content_of(picture_) == picture);
      });
}

// If the disk goes away during a render, the render goes on, and the last checkpoint can be resumed.
TEST_F(FailingCall, OfASavingOnTheWay) {
  const Words sitting = {"render",    scene_,     "--quiet", "-o",      picture_,  "--checkpoint",
                         checkpoint_, "--resume", "--rays",  "1000000", "--every", "0.05s"};
  for (const int call : {1, 2, 3, 8}) {
    const auto [code, failed] = run_with_failure(sitting + Words{"--time-limit", "1s"}, call, "GONE");
    EXPECT_TRUE(code == 73 || code == 74) << code << " " << failed;
    EXPECT_TRUE(said().starts_with("penumbra: warning: the checkpoint ")) << said();
  }
  EXPECT_EQ(run(sitting + Words{"--time-limit", "0.1s"}), 75) << said();
}

}  // namespace
}  // namespace penumbra::test
