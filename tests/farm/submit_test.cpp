// What `farm submit` writes and submits, and what it refuses.
#include <gtest/gtest.h>

#include "farm/farm_fixture.hpp"

namespace penumbra::test {
namespace {

class FarmSubmit : public FarmTest {};

TEST_F(FarmSubmit, AnArrayAndAMergeAfterIt) {
  ASSERT_EQ(submit({"--shards", "5", "--partition", "render", "--time", "2h"}), 0) << said();
  const std::string place = folder().path().string();
  EXPECT_EQ(submissions(), "--parsable\n--array=0-4\n--chdir=" + place + "\n" + place + "/shard.sh\n--\n" +
                               "--parsable\n--dependency=afterany:101\n--chdir=" + place + "\n" + place +
                               "/merge.sh\n--\n");
  EXPECT_NE(said().find("submitted: 101 renders, 102 merges"), std::string::npos) << said();
  const std::string script = content_of(folder().shard_script());
  EXPECT_NE(script.find("#SBATCH --partition=render\n#SBATCH --time=120\n"), script.npos) << script;
  EXPECT_TRUE(folder().read_state().submitted);
}

TEST_F(FarmSubmit, DryRunOnlyWrites) {
  ASSERT_EQ(submit({"--shards", "5", "--dry-run"}), 0) << said();
  EXPECT_EQ(submissions(), "");
  EXPECT_NE(said().find("  sbatch --parsable --array=0-4 "), std::string::npos) << said();
  EXPECT_NE(said().find(" --dependency=afterany:ID "), std::string::npos) << said();
  EXPECT_FALSE(folder().read_state().submitted);
  EXPECT_EQ(submit({"--shards", "3"}), 0) << said();  // replaces a job that never began
  EXPECT_EQ(job().shards, 3);
}

TEST_F(FarmSubmit, RefusesAFolderThatIsTaken) {
  ASSERT_EQ(submit({"--shards", "2"}), 0) << said();
  EXPECT_EQ(submit({"--shards", "2"}), 73);
  EXPECT_NE(said().find("is the folder of a job that has begun"), std::string::npos) << said();
  EXPECT_EQ(submit({"--shards", "2", "--folder", work_.string()}), 73);
  EXPECT_NE(said().find("is not a job folder"), std::string::npos) << said();
  EXPECT_EQ(submit({"--shards", "2", "--folder", (work_ / "second").string()}), 0) << said();
}

// Each option reaches the shards as given: the result is that of the same render by hand.
TEST_F(FarmSubmit, OptionsReachTheShards) {
  const Words options = {
      "--rays",    "3",         "--aov",           "depth,normal", "--no-shadows", "--sampler", "halton",
      "--seed",    "11",        "--bits",          "16",           "--max-depth",  "3",         "--crop",
      "5,7,50,30", "--lenient", "--sampler-light", "regular"};
  ASSERT_EQ(submit(options + Words{"--shards", "3", "--shutter-time", "0.25"}), 0) << said();
  run_all_tasks();
  ASSERT_EQ(collect(), 0) << said();
  EXPECT_TRUE(content_of(output_) == single_machine(options + Words{"--time", "0.25"}));
}

TEST_F(FarmSubmit, ThreadsAreProcessorsOfATask) {
  ASSERT_EQ(submit({"--shards", "2", "--threads", "3"}), 0) << said();
  const std::string script = content_of(folder().shard_script());
  EXPECT_NE(script.find("#SBATCH --cpus-per-task=3\n"), script.npos);
  EXPECT_NE(script.find(" --threads 3\n"), script.npos);
}

// Four shards for each task that the partition runs at once, but no more than there is work for.
TEST_F(FarmSubmit, AutomaticShards) {
  const Words large = {"submit", scene_file_, "--dry-run", "--size", "640x480", "-o", output_};
  ASSERT_EQ(farm(large), 0) << said();
  EXPECT_EQ(job().shards, 24);  // 6 processors
  ASSERT_EQ(farm(large + Words{"--threads", "3"}), 0) << said();
  EXPECT_EQ(job().shards, 8);
  put_program("sinfo", "exit 1\n");
  ASSERT_EQ(farm(large), 0) << said();
  EXPECT_EQ(job().shards, 24);
  ASSERT_EQ(submit({"--dry-run"}), 0) << said();
  EXPECT_EQ(job().shards, 1);  // of 35 tiles
}

TEST_F(FarmSubmit, SeveralPicturesOfOneScene) {
  put_content(scene_file_, scene_text(2) + "render\nbackground 1 0 0\nrender\n");
  ASSERT_EQ(submit({"--shards", "2"}), 0) << said();
  EXPECT_EQ(job().pictures, 2);
  run_all_tasks();
  ASSERT_EQ(collect(), 0) << said();
  single_machine();
  for (const char* number : {"-1", "-2"}) {
    const std::string bytes = content_of(work_ / ("the 'picture'" + std::string(number) + ".exr"));
    EXPECT_FALSE(bytes.empty());
    EXPECT_TRUE(bytes == content_of(work_ / ("single" + std::string(number) + ".exr")));
  }
}

// Every frame is its own picture; its parts are named after it, and a part of another frame is refused.
TEST_F(FarmSubmit, Animations) {
  put_content(scene_file_, scene_text(2) + "background {t} 0 {frame / 10}\n");
  const Words frames = {"--frames", "3-9x3"};
  ASSERT_EQ(submit(frames + Words{"--shards", "2"}), 0) << said();
  EXPECT_EQ(job().units(), 6);
  EXPECT_EQ(job().frame_of(3), 6);
  EXPECT_NE(submissions().find("--array=0-5\n"), std::string::npos);
  run_all_tasks();
  EXPECT_TRUE(std::filesystem::exists(folder().parts() / "5.0009.exr"));
  EXPECT_EQ(run_task(5).output, "");
  const auto part = [&](int unit) { return folder().part(job(), unit, 1); };
  const std::string kept = content_of(part(2));
  std::filesystem::copy_file(part(0), part(2), std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(collect(), 65);
  EXPECT_NE(said().find("it is not the part that its name says"), std::string::npos) << said();
  EXPECT_TRUE(std::filesystem::exists(work_ / "the 'picture'.0003.exr"));  // complete frames are written
  EXPECT_FALSE(std::filesystem::exists(work_ / "the 'picture'.0006.exr"));
  put_content(part(2), kept);
  ASSERT_EQ(collect(), 0) << said();
  single_machine(frames);
  for (const char* number : {".0003", ".0006", ".0009"}) {
    const std::string bytes = content_of(work_ / ("the 'picture'" + std::string(number) + ".exr"));
    EXPECT_FALSE(bytes.empty());
    EXPECT_TRUE(bytes == content_of(work_ / ("single" + std::string(number) + ".exr"))) << number;
  }
}

TEST_F(FarmSubmit, AnErrorInAnyFrame) {
  put_content(scene_file_, scene_text(2) + "background {1 / (frame - 5)} 0 0\n");
  EXPECT_EQ(submit({"--frames", "3-4"}), 0) << said();
  EXPECT_EQ(submit({"--frames", "3-6", "--folder", (work_ / "second").string()}), 65) << said();
}

TEST_F(FarmSubmit, Refusals) {
  EXPECT_EQ(submit({"--shards", "0"}), 64);
  EXPECT_EQ(submit({"--shards", "many"}), 64);
  EXPECT_EQ(submit({"--shards", "49"}), 64);
  EXPECT_NE(said().find("the picture has only 35 tiles"), std::string::npos) << said();
  EXPECT_EQ(submit({"--time", "soon"}), 64);
  EXPECT_EQ(submit({"--partition", "a b"}), 64);
  EXPECT_EQ(submit({"--partition", "a\n#SBATCH --uid=0"}), 64);
  EXPECT_EQ(submit({"--rays", "none"}), 64);
  EXPECT_EQ(submit({"--checkpoint", "x"}), 64);
  EXPECT_EQ(farm({"submit", scene_file_}), 64);
  EXPECT_EQ(farm({"submit", scene_file_, "-o", (work_ / "a.jpg").string()}), 64);
  EXPECT_EQ(farm({"submit", scene_file_, "-o", (work_ / "none" / "a.exr").string()}), 73);
  EXPECT_EQ(farm({"submit", (work_ / "none.cli").string(), "-o", output_}), 66);
  EXPECT_EQ(farm({}), 64);
  put_content(scene_file_, "shpere 1 0 0 0\n");
  EXPECT_EQ(submit(), 65);
  EXPECT_FALSE(std::filesystem::exists(folder().path()));
}

TEST_F(FarmSubmit, SaysThatSlurmIsNotThere) {
  put_program("sbatch", "echo 'sbatch: error: Batch job submission failed: Invalid account' >&2\nexit 1\n");
  EXPECT_EQ(submit({"--shards", "2"}), 69);
  EXPECT_NE(said().find("Invalid account"), std::string::npos) << said();
  EXPECT_FALSE(folder().read_state().submitted);
}

}  // namespace
}  // namespace penumbra::test
