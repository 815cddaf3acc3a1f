// How `farm collect` treats parts that are present, missing, damaged or foreign.
#include <gtest/gtest.h>

#include "farm/farm_fixture.hpp"

namespace penumbra::test {
namespace {

class FarmCollect : public FarmTest {
 protected:
  FarmCollect() { EXPECT_EQ(submit({"--shards", "4", "--rays", "2"}), 0) << said(); }

  std::string part(int unit) const { return folder().part(job(), unit, 1).string(); }
  bool is_picture() const { return content_of(output_) == single_machine({"--rays", "2"}); }
};

TEST_F(FarmCollect, WritesThePictureOfASingleMachine) {
  run_all_tasks();
  ASSERT_EQ(collect(), 0) << said();
  EXPECT_TRUE(is_picture());
  EXPECT_TRUE(status().at("finished"));
  EXPECT_EQ(collect(), 0) << said();
  std::filesystem::remove(output_);
  EXPECT_EQ(collect(), 0) << said();
  EXPECT_TRUE(is_picture());
}

TEST_F(FarmCollect, NamesWhatIsMissingOrDamaged) {
  run_all_tasks();
  std::filesystem::remove(part(1));
  put_content(part(3), content_of(part(3)).substr(0, 4000));
  EXPECT_EQ(collect(), 65);
  EXPECT_NE(said().find("parts/3.exr` is a truncated part of a picture"), std::string::npos) << said();
  EXPECT_NE(said().find("of 4 parts, numbered from 0, 2 are missing: 1,3\n"), std::string::npos) << said();
  EXPECT_FALSE(std::filesystem::exists(output_));
  EXPECT_TRUE(std::filesystem::exists(part(3)));
}

TEST_F(FarmCollect, SubmitsWhatIsMissingAFewTimes) {
  run_all_tasks();
  std::filesystem::remove(part(1));
  put_content(part(3), content_of(part(3)).substr(0, 4000));
  std::filesystem::remove(tools_ / "sbatch.log");
  ASSERT_EQ(collect({"--resubmit", "3"}), 0) << said();
  EXPECT_FALSE(std::filesystem::exists(part(3)));  // otherwise it would count as done
  EXPECT_NE(submissions().find("--array=1,3\n"), std::string::npos) << submissions();
  EXPECT_NE(submissions().find("--dependency=afterany:101\n"), std::string::npos) << submissions();
  EXPECT_EQ(collect({"--resubmit", "3"}), 0) << said();
  EXPECT_EQ(collect({"--resubmit", "3"}), 0) << said();
  EXPECT_EQ(folder().read_state().resubmissions, 3);
  const std::string before = submissions();
  EXPECT_EQ(collect({"--resubmit", "3"}), 65);
  EXPECT_NE(said().find("they were resubmitted 3 times"), std::string::npos) << said();
  EXPECT_EQ(submissions(), before);
  EXPECT_EQ(collect({"--resubmit"}), 0) << said();  // by hand, once more
  run_all_tasks();
  EXPECT_EQ(collect(), 0) << said();
  EXPECT_TRUE(is_picture());
}

// Tasks that Slurm still works on are not resubmitted.
TEST_F(FarmCollect, WaitsForWhatRuns) {
  ASSERT_EQ(run_task(0).exit_code, 0);
  const std::string name = job().name;
  set_queue(name + "|101|1|RUNNING|0:01|None\n" + name + "|101|2|PENDING|0:00|BeginTime\n" + name +
            "|101|3|RUNNING|0:01|None\n");
  EXPECT_EQ(collect(), 75);
  std::filesystem::remove(tools_ / "sbatch.log");
  EXPECT_EQ(collect({"--resubmit", "3"}), 0) << said();
  EXPECT_EQ(submissions().find("--array"), std::string::npos) << submissions();
  EXPECT_NE(submissions().find("--dependency=afterany:101\n"), std::string::npos) << submissions();
  EXPECT_EQ(folder().read_state().resubmissions, 0);

  set_queue(name + "|101|1|RUNNING|0:01|None\n" + name + "|101|2|RUNNING|0:00|None\n");
  std::filesystem::remove(tools_ / "sbatch.log");
  EXPECT_EQ(collect({"--resubmit", "3"}), 0) << said();
  EXPECT_NE(submissions().find("--array=3\n"), std::string::npos) << submissions();
  EXPECT_NE(submissions().find("--dependency=afterany:101\n"), std::string::npos) << submissions();
}

TEST_F(FarmCollect, RendersHereWhatIsMissing) {
  ASSERT_EQ(run_task(2).exit_code, 0);
  put_program("squeue", "exit 1\n");
  const std::string kept = content_of(part(2));
  EXPECT_EQ(collect({"--render"}), 0) << said();
  EXPECT_EQ(said().find("unit 2 begins"), std::string::npos) << said();
  EXPECT_TRUE(is_picture());
}

TEST_F(FarmCollect, RefusesPartsOfOtherPictures) {
  run_all_tasks();
  std::filesystem::copy_file(part(0), part(1), std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(collect(), 65);
  EXPECT_NE(said().find("parts/1.exr` does not belong to this job: it is not the part that its name says"),
            std::string::npos)
      << said();
  ASSERT_EQ(run({"render", scene_file_, "--size", "53x37", "--rays", "5", "--shard", "1/4", "-o", part(1)}), 0);
  EXPECT_EQ(collect(), 65);
  EXPECT_NE(said().find("its `rays` is 5, but 2 in the others"), std::string::npos) << said();
  EXPECT_FALSE(std::filesystem::exists(output_));
}

// A scene that has changed since it was submitted is not rendered, and nothing is retried.
TEST_F(FarmCollect, RefusesAChangedScene) {
  const std::string before = content_of(scene_file_);
  put_content(scene_file_, before + "# changed\n");
  const ProgramResult result = run_task(0);
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_NE(result.output.find("or a file that it reads, has changed: the hash of its files is "), std::string::npos)
      << result.output;
  std::filesystem::remove(tools_ / "sbatch.log");
  EXPECT_EQ(collect({"--resubmit", "3"}), 65);
  EXPECT_NE(said().find("has changed since the job was submitted"), std::string::npos) << said();
  EXPECT_EQ(submissions(), "");
  std::filesystem::remove(scene_file_);
  EXPECT_EQ(collect({"--render"}), 66);
  put_content(scene_file_, before);
  EXPECT_EQ(collect({"--render"}), 0) << said();
}

// Existing parts are not rendered again.
TEST_F(FarmCollect, TasksSkipWhatIsDone) {
  EXPECT_NE(run_task(1).output.find("unit 1 begins on "), std::string::npos);
  const ProgramResult again = run_task(1);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.output, "");
}

// In a Slurm array, a task that has to end asks to be requeued; elsewhere it only reports it.
TEST_F(FarmTest, ExitCode75IsAnotherTurn) {
  ASSERT_EQ(submit({"--shards", "2", "--rays", "200000", "--dry-run"}), 0) << said();
  const std::string script = folder().shard_script().string();
  std::string text = content_of(script);
  const std::size_t place = text.find(" --progress none");
  ASSERT_NE(place, text.npos);
  text.insert(place, " --time-limit 0.05");
  put_content(script, text);
  EXPECT_EQ(run_task(1).exit_code, 75);
  EXPECT_FALSE(std::filesystem::exists(tools_ / "scontrol.log"));
  EXPECT_TRUE(std::filesystem::exists(folder().path() / "checkpoints" / "1"));
  const ProgramResult result =
      run_program("export TOOLS=" + quoted(tools_.string()) + "; export PATH=\"$TOOLS:$PATH\"; " +
                  "SLURM_ARRAY_TASK_ID=1 SLURM_JOB_ID=104 bash " + quoted(script));
  EXPECT_EQ(result.exit_code, 75) << result.output;
  EXPECT_EQ(result.output.find("from the beginning"), std::string::npos) << result.output;
  EXPECT_EQ(content_of(tools_ / "scontrol.log"), "requeue 104\n");
}

}  // namespace
}  // namespace penumbra::test
