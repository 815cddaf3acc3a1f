// What Slurm prints, and what it is asked to do.
#include "farm/slurm.hpp"

#include <gtest/gtest.h>

#include "farm/child_process.hpp"

namespace penumbra::test {
namespace {

TEST(SlurmTime, IsInMinutes) {
  const std::pair<const char*, int> times[] = {{"90", 90},        {"30m", 30},   {"90s", 2},    {"1s", 1},
                                               {"2h", 120},       {"1.5h", 90},  {"1d", 1440},  {"10:00", 10},
                                               {"2:00:00", 120},  {"0:61", 2},   {"1-0", 1440}, {"1-12", 2160},
                                               {"1-12:30", 2190}, {"30min", 30}, {"0-0:0:1", 1}};
  for (const auto& [text, minutes] : times) EXPECT_EQ(slurm_minutes(text), minutes) << text;
  for (const char* text : {"", "0", "-1", "abc", "1x", "1:2:3:4", "1-", "-", ":", "1:", "1--2", "nan", "inf", "1e99",
                           "99999d", "99999999999999999999", "1 h"}) {
    EXPECT_FALSE(slurm_minutes(text)) << text;
  }
}

TEST(Queue, IsRead) {
  Job job;
  job.name = "a-1";
  const Queue queue = parse_queue(job,
                                  "a-1|26|0|RUNNING|0:05|None\n"
                                  "a-1|26|3|RUNNING|1-02:03:04|None\n"
                                  "a-1|40|7|PENDING|0:00|BeginTime\n"
                                  "a-1-merge|27|N/A|PENDING|0:00|Dependency\n"
                                  "other|28|1|RUNNING|0:01|None\n"
                                  "rubbish\n");
  ASSERT_EQ(queue.tasks.size(), 3u);
  EXPECT_TRUE(queue.tasks.at(0).runs);
  EXPECT_EQ(queue.tasks.at(0).seconds, 5);
  EXPECT_EQ(queue.tasks.at(3).seconds, 86400 + 2 * 3600 + 3 * 60 + 4);
  EXPECT_FALSE(queue.tasks.at(7).runs);
  EXPECT_EQ(queue.tasks.at(7).reason, "BeginTime");
  EXPECT_EQ(queue.ids, (std::set<std::string>{"26", "40"}));
  ASSERT_TRUE(queue.merge);
  EXPECT_FALSE(queue.merge->runs);
}

TEST(Commands, NameThePlace) {
  const JobFolder folder("/a b");
  EXPECT_EQ(shards_command(folder, {0, 1, 5}),
            (std::vector<std::string>{"sbatch", "--parsable", "--array=0-1,5", "--chdir=/a b", "/a b/shard.sh"}));
  EXPECT_EQ(
      merge_command_after(folder, {"7", "9"}),
      (std::vector<std::string>{"sbatch", "--parsable", "--dependency=afterany:7:9", "--chdir=/a b", "/a b/merge.sh"}));
}

TEST(ChildProcess, TellsWhatCameOfIt) {
  const ChildResult result = run_child({"bash", "-c", "echo out; echo err >&2; exit 3"}, 30);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "out\n");
  EXPECT_EQ(result.errors, "err\n");
  EXPECT_EQ(run_child({"there-is-no-such-program"}, 30).exit_code, 127);
  EXPECT_EQ(run_child({"head", "-c", "300000", "/dev/zero"}, 30).output.size(), 300000u);
}

TEST(ChildProcess, IsNotWaitedForTooLong) {
  const ChildResult result = run_child({"sleep", "600"}, 0.05);
  EXPECT_EQ(result.exit_code, 128 + 9);
  EXPECT_EQ(result.errors, "timed out");
}

}  // namespace
}  // namespace penumbra::test
