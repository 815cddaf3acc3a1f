// `penumbra render --checkpoint` and its options as users call them: what they resume, and what they refuse.
#include <gtest/gtest.h>

#include "rendering/checkpoint.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

class CheckpointOption : public SittingTest {
 protected:
  // Leaves the checkpoint of an unfinished render with these arguments, however fast the machine is.
  void begin(const Words& arguments) const {
    int exit_code = 0;
    for (const char* limit : {"0.3s", "0.1s", "0.03s", "0.01s", "0.001s"}) {
      std::filesystem::remove(checkpoint_);
      exit_code = render(arguments + Words{"--checkpoint", checkpoint_, "--time-limit", limit, "-o", picture_});
      std::filesystem::remove(picture_);
      if (exit_code != 0) break;
    }
    ASSERT_EQ(exit_code, 75) << said();
  }
  int resume(const Words& arguments) const {
    return render(arguments + Words{"--checkpoint", checkpoint_, "--resume", "-o", picture_});
  }

  const Words long_render_ = {"--rays", "1000000"};
};

TEST_F(CheckpointOption, RefusesAnotherRender) {
  begin(long_render_);
  const std::string refusal = "penumbra: `" + checkpoint_ + "` is the checkpoint of another render: ";
  EXPECT_EQ(resume({"--rays", "20"}), 65);
  EXPECT_EQ(said(), refusal + "its `rays` is 1000000, but 20 here\n");
  EXPECT_EQ(resume(long_render_ + Words{"--crop", "0,0,9,9"}), 65);
  EXPECT_EQ(said(), refusal + "its `crop` is not given, but 0,0,9,9 here\n");
  EXPECT_EQ(resume(long_render_ + Words{"--aov", "normal,depth"}), 65);
  EXPECT_EQ(said(), refusal + "its `aov` is not given, but depth,normal here\n");
  EXPECT_EQ(resume(long_render_ + Words{"--noise", "0.1"}), 65);
  EXPECT_EQ(resume(long_render_ + Words{"--shard", "0/2"}), 65);
  EXPECT_EQ(said(), refusal + "its `shard` is not given, but 0/2 here\n");
  put_content(scene_, scene_text(16) + "# changed\n");
  EXPECT_EQ(resume(long_render_), 65);
  EXPECT_EQ(said(), refusal + "the scene, or a file that it reads, is not the same\n");
  EXPECT_EQ(others(), (Words{"checkpoint"})) << "no picture was written";
}

TEST_F(CheckpointOption, RefusesAnotherMesh) {
  put_content(path("mesh.obj"), "v 0 0 -5\nv 1 0 -5\nv 0 1 -5\nf 1 2 3\n");
  put_content(scene_, scene_text(16) + "mesh mesh.obj\n");
  begin(long_render_);
  put_content(path("mesh.obj"), "v 0 0 -5\nv 1 0 -5\nv 0 1 -4\nf 1 2 3\n");
  EXPECT_EQ(resume(long_render_), 65);
  EXPECT_NE(said().find("a file that it reads, is not the same"), std::string::npos) << said();
}

// What does not change the picture may change from session to session.
TEST_F(CheckpointOption, ThreadsAndFilesMayChange) {
  const Words arguments = {"--rays", "600"};
  const std::string whole = unbroken(arguments).first;
  begin(arguments + Words{"--threads", "1", "--bits", "16"});
  EXPECT_EQ(resume(arguments + Words{"--threads", "3", "-o", path("other.png")}), 0) << said();
  EXPECT_TRUE(content_of(picture_) == whole);
  EXPECT_EQ(others(), (Words{"other.png", "picture.exr"}));
}

// The samples of a sequence do not depend on how many there will be.
TEST_F(CheckpointOption, MoreRaysGoOnFromFewer) {
  for (const char* sampler : {"random", "halton", "sobol", "bluenoise"}) {
    const Words arguments = {"--sampler", sampler, "--aov", "depth,variance"};
    const std::string whole = unbroken(arguments + Words{"--rays", "75"}).first;
    ASSERT_EQ(resume(arguments + Words{"--rays", "20", "--keep-checkpoint"}), 0) << said();
    ASSERT_TRUE(std::filesystem::exists(checkpoint_));
    ASSERT_EQ(run(Words{"render", scene_, "-o", picture_, "--checkpoint", checkpoint_, "--resume", "--rays", "75",
                        "--stats", path("stats")} +
                  arguments),
              0)
        << said();
    EXPECT_TRUE(content_of(picture_) == whole) << sampler;
    EXPECT_EQ(others(), (Words{"picture.exr", "stats"}));
  }
  begin(long_render_);
  ASSERT_EQ(
      render({"--rays", "2000000", "--checkpoint", checkpoint_, "--resume", "--time-limit", "0.1s", "-o", picture_}),
      75)
      << "an unfinished one, too";
  EXPECT_EQ(resume(long_render_), 65) << "nothing goes back to fewer";
}

TEST_F(CheckpointOption, MoreRaysAreRefusedWhereThePatternDependsOnTheirNumber) {
  for (const Words& arguments :
       {Words{"--rays", "9", "--sampler", "jittered"}, Words{"--rays", "9", "--sampler", "poisson"},
        Words{"--rays", "1"}, Words{"--rays", "9", "--sampler-light", "regular"},
        Words{"--rays", "16", "--noise", "0.5"}}) {
    ASSERT_EQ(render(arguments + Words{"--checkpoint", checkpoint_, "--keep-checkpoint", "-o", picture_}), 0) << said();
    Words more = arguments;
    more[1] = "25";
    EXPECT_EQ(resume(more), 65);
    EXPECT_NE(said().find("with --sampler random, halton, sobol, bluenoise"), std::string::npos) << said();
  }
}

// A kept checkpoint is of the last picture: the ones before it have to be rendered again.
TEST_F(CheckpointOption, MoreRaysForSeveralPictures) {
  put_content(scene_, scene_text(4) + "write first.png\nlight 0 9 9 .1 .1 .1\nwrite second.png\n");
  ASSERT_EQ(render({"--rays", "40", "-o", path("whole.exr")}), 0);
  ASSERT_EQ(resume({"--rays", "20", "--keep-checkpoint"}), 0);
  ASSERT_EQ(resume({"--rays", "40"}), 0) << said();
  for (const char* number : {"-1", "-2"}) {
    EXPECT_TRUE(content_of(path("picture" + std::string(number) + ".exr")) ==
                content_of(path("whole" + std::string(number) + ".exr")));
  }
}

TEST_F(CheckpointOption, ADamagedOneGivesWayToTheOneBefore) {
  const Words arguments = {"--rays", "600"};
  const std::string whole = unbroken(arguments).first;
  begin(arguments);
  const std::string good = content_of(checkpoint_);
  put_content(checkpoint_ + ".previous", good);
  std::string bad = good;
  bad[bad.size() / 2] ^= 1;
  put_content(checkpoint_, bad);
  // Stopped at once, which must leave the good one.
  const Words command =
      Words{"render", scene_, "--progress", "none", "--checkpoint", checkpoint_, "--resume", "-o", picture_} +
      arguments;
  EXPECT_EQ(run(command + Words{"--time-limit", "0.001s"}), 75);
  EXPECT_NE(said().find("penumbra: warning: `" + checkpoint_ + "` is a damaged checkpoint: block"), std::string::npos)
      << said();
  EXPECT_TRUE(content_of(checkpoint_ + ".previous") == good);
  EXPECT_EQ(run(command), 0) << said();
  EXPECT_EQ(said().find("warning"), std::string::npos) << said();
  EXPECT_TRUE(content_of(picture_) == whole);

  put_content(checkpoint_, bad);
  EXPECT_EQ(run(command), 65);
  EXPECT_TRUE(said().starts_with("penumbra: `" + checkpoint_ + "` is a damaged checkpoint: block")) << said();
}

TEST_F(CheckpointOption, WithoutResumeItBeginsAnew) {
  const Words arguments = {"--rays", "16"};
  const std::string whole = unbroken(arguments).first;
  begin(long_render_);
  EXPECT_EQ(run(Words{"render", scene_, "-o", picture_, "--checkpoint", checkpoint_} + arguments), 0);
  EXPECT_NE(
      said().find("warning: rendering from the beginning, without --resume: `" + checkpoint_ + "` will be replaced"),
      std::string::npos)
      << said();
  EXPECT_TRUE(content_of(picture_) == whole);
}

TEST_F(CheckpointOption, WithNothingToResumeItBeginsAtTheBeginning) {
  EXPECT_EQ(run(Words{"render", scene_, "-o", picture_, "--checkpoint", checkpoint_, "--resume"}), 0);
  EXPECT_NE(said().find("there is no checkpoint `" + checkpoint_ + "` yet"), std::string::npos) << said();
}

// A file that the user names by mistake is left alone.
TEST_F(CheckpointOption, ReplacesNothingButCheckpoints) {
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", scene_}), 64);
  EXPECT_EQ(content_of(scene_), scene_text(16));
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", log_}), 73);
  EXPECT_NE(said().find("a file of another kind"), std::string::npos) << said();
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", folder_.path().string()}), 73);
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", "/dev/null"}), 73);
  EXPECT_EQ(render({"-o", picture_, "--checkpoint", path("none/checkpoint")}), 73);
  EXPECT_EQ(others(), Words{});
}

TEST_F(CheckpointOption, WrongWords) {
  for (const Words& wrong : {Words{"--resume"},
                             {"--every", "5s"},
                             {"--keep-checkpoint"},
                             {"--checkpoint", checkpoint_, "--every", "0s"},
                             {"--time-limit", "soon"},
                             {"--time-limit", "5x"},
                             {"--time-limit", "-3s"},
                             {"--shard", "2/2", "-o", picture_},
                             {"--shard", "1", "-o", picture_},
                             {"--shard", "-1/2", "-o", picture_},
                             {"--shard", "0/2"},
                             {"--shard", "0/2", "-o", path("part.png")},
                             {"--shard", "0/2", "-o", picture_, "-o", path("second.exr")}}) {
    EXPECT_EQ(render(wrong), 64) << wrong.back() << said();
    EXPECT_NE(said(), "");
  }
  EXPECT_EQ(others(), Words{});
}

// The first picture is not rendered again when the second was interrupted.
TEST_F(CheckpointOption, ScenesWithSeveralPictures) {
  put_content(scene_, scene_text(600) + "write first.png\nlight 0 9 9 .1 .1 .1\nwrite second.png\n");
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(render({"-o", path("whole.exr")}), 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Words command = {"-o", picture_, "--checkpoint", checkpoint_, "--resume", "--every", "0.05s"};
  int skipped = 0;
  for (int code; (code = render(command + Words{"--time-limit", std::to_string(seconds / 5)})) != 0;) {
    ASSERT_EQ(code, 75) << said();
    const LastCheckpoint last = read_last_checkpoint(checkpoint_);
    ASSERT_TRUE(last.checkpoint);
    skipped += last.checkpoint->key().picture == 2;
  }
  EXPECT_GT(skipped, 0);
  EXPECT_TRUE(content_of(path("picture-1.exr")) == content_of(path("whole-1.exr")));
  EXPECT_TRUE(content_of(path("picture-2.exr")) == content_of(path("whole-2.exr")));
  EXPECT_EQ(others(), (Words{"picture-1.exr", "picture-2.exr", "whole-1.exr", "whole-2.exr"}));
}

}  // namespace
}  // namespace penumbra::test
