// The text of the scripts, and the quoting of words in them.
#include "base/shell_words.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/test_folder.hpp"
#include "farm/job.hpp"

namespace penumbra::test {
namespace {

Job small_job() {
  return {.version = "1",
          .name = "name",
          .program = "/opt/penumbra",
          .scene = "/shared/a scene.cli",
          .scene_hash = "0123",
          .options = {"--rays", "64", "--no-shadows"},
          .partition = {},
          .minutes = {},
          .shards = 24,
          .frames = {},
          .outputs = {{{"/shared/a.exr"}}}};
}

bool contains(const std::string& text, const std::string& piece) { return text.find(piece) != text.npos; }

TEST(ShellWord, IsReadBackByAShell) {
  for (const std::string text : {"plain", "", "a b", "it's", "'", "''", "\"quoted\"", "$HOME `date` $(date)", "a\\b",
                                 "line\nline", "*?[a]", "~", "#no comment", "a;b&c|d", "!x", "-o", "\xff\xfe"}) {
    const ProgramResult result = run_program("bash -c " + shell_word("printf %s " + shell_word(text)));
    EXPECT_EQ(result.output, text);
  }
  EXPECT_EQ(shell_words({"a", "b c", "--x=1"}), "a 'b c' --x=1");
}

TEST(ShardScript, ReadsWell) {
  const std::string script = shard_script(small_job(), JobFolder("/shared/a.exr.farm"));
  EXPECT_EQ(
      script,
      "#!/bin/bash\n"
      "#SBATCH --job-name=name\n"
      "#SBATCH --output=logs/%a.log\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --requeue\n"
      "#SBATCH --cpus-per-task=1\n"
      "# Renders the shards of one task: ./shard.sh TASK, or Slurm sets TASK. Existing parts are not rendered again.\n"
      "cd /shared/a.exr.farm || exit 73\n"
      "task=${1:-$SLURM_ARRAY_TASK_ID}\n"
      "for ((unit = task; unit < 24; unit += 24)); do\n"
      "  [ -s \"parts/$unit.exr\" ] && continue\n"
      "  echo \"unit $unit begins on $(hostname), $(date)\"\n"
      "  /opt/penumbra render '/shared/a scene.cli' \\\n"
      "    --shard \"$unit/24\" -o \"parts/$unit.exr\" --stats \"stats/$unit.json\" \\\n"
      "    --checkpoint \"checkpoints/$unit\" --resume \\\n"
      "    --scene-hash 0123 --progress none \\\n"
      "    --rays 64 --no-shadows\n"
      "  code=$?\n"
      "  # Out of time or interrupted: the checkpoint is written, and the render resumes on its next turn.\n"
      "  [ $code -eq 75 ] && [ $# -eq 0 ] && scontrol requeue \"$SLURM_JOB_ID\"\n"
      "  [ $code -eq 0 ] || exit $code\n"
      "done\n");
}

TEST(ShardScript, EndsBeforeSlurmEndsIt) {
  Job job = small_job();
  for (const auto& [minutes, seconds] : {std::pair{1, 45}, {10, 540}, {600, 35880}}) {
    job.minutes = minutes;
    const std::string script = shard_script(job, JobFolder("/a"));
    EXPECT_TRUE(contains(script, fmt::format("#SBATCH --time={}\n", minutes))) << script;
    EXPECT_TRUE(contains(script, fmt::format(" --time-limit {}s ", seconds))) << script;
  }
}

TEST(ShardScript, AsksForPartitionAndProcessors) {
  Job job = small_job();
  job.partition = "gpu-night";
  job.threads = 8;
  const std::string script = shard_script(job, JobFolder("/a"));
  EXPECT_TRUE(contains(script, "#SBATCH --partition=gpu-night\n"));
  EXPECT_TRUE(contains(script, "#SBATCH --cpus-per-task=8\n"));
  EXPECT_TRUE(contains(merge_script(job, JobFolder("/a")), "#SBATCH --cpus-per-task=1\n"));
}

// Slurm's arrays are limited: if there are more units than tasks, the tasks share them.
TEST(ShardScript, SharesManyUnitsOut) {
  Job job = small_job();
  job.shards = 2500;
  EXPECT_EQ(job.tasks(), 1000);
  EXPECT_EQ(job.task_of(2499), 499);
  EXPECT_TRUE(contains(shard_script(job, JobFolder("/a")), "for ((unit = task; unit < 2500; unit += 1000)); do\n"));
}

TEST(ShardScript, FramesOfAnAnimation) {
  Job job = small_job();
  job.shards = 2;
  job.frames = {3, 90, 3, 4};
  job.outputs.resize(30, job.outputs.front());
  const std::string script = shard_script(job, JobFolder("/a"));
  EXPECT_TRUE(contains(script,
                       "for ((unit = task; unit < 60; unit += 60)); do\n"
                       "  shard=$((unit % 2))\n"
                       "  frame=$((3 + 3 * (unit / 2)))\n"
                       "  [ -s \"parts/$unit.$(printf %04d $frame).exr\" ] && continue\n"))
      << script;
  EXPECT_TRUE(contains(script, " --shard \"$shard/2\" -o \"parts/$unit.exr\" ")) << script;
  EXPECT_TRUE(contains(script, " --frames 3-90x3 --frame \"$frame\" ")) << script;
}

TEST(MergeScript, Collects) {
  const std::string script = merge_script(small_job(), JobFolder("/shared/a b"));
  EXPECT_TRUE(contains(script, "cd '/shared/a b' || exit 73\n/opt/penumbra farm collect . --resubmit 3\n")) << script;
  EXPECT_TRUE(contains(script, "#SBATCH --job-name=name-merge\n"));
}

TEST(Ranges, AreSlurms) {
  EXPECT_EQ(ranges({}), "");
  EXPECT_EQ(ranges({3}), "3");
  EXPECT_EQ(ranges({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
}

}  // namespace
}  // namespace penumbra::test
