// The progress of a job, from its folder and the queue.
#include "farm/status.hpp"

#include <gtest/gtest.h>

#include "farm/farm_fixture.hpp"

namespace penumbra::test {
namespace {

Job job_of(int shards, int frames = 1) {
  Job job;
  job.name = "a-1";
  job.scene = "/a.cli";
  job.shards = shards;
  for (int i = 0; i < frames; i++) job.outputs.push_back({{"/a" + std::to_string(i) + ".exr"}});
  return job;
}

const auto noon = WallClock::from_time_t(1'700'000'000);

TEST(JobStatus, TellsDoneRunningWaitingAndLost) {
  const Job job = job_of(6);
  Queue queue;
  queue.tasks[1] = {true, "RUNNING", "None", 4};
  queue.tasks[2] = {false, "PENDING", "Resources", 0};
  const JobStatus status = status_of(job, {}, {true, false, false, false, false, true}, queue, "", 10.0);
  EXPECT_EQ(status.done, (std::set<int>{0, 5}));
  EXPECT_EQ(status.running, (std::set<int>{1}));
  EXPECT_EQ(status.waiting, (std::set<int>{2}));
  EXPECT_EQ(status.lost, (std::set<int>{3, 4}));
  EXPECT_DOUBLE_EQ(status.seconds_left.value(), 16);  // 6 s for the running unit, 10 s for the waiting one
  const std::string text = to_text(job, status, noon);
  EXPECT_NE(text.find("a-1: 2 of 6 parts are done\n  done          2\n  running       1   1\n"), text.npos) << text;
  EXPECT_NE(text.find("  lost          2   3-4\n  waiting for: Resources\nestimated end: "), text.npos) << text;
  EXPECT_NE(text.find(" (in 16 s), if as many keep running\n"), text.npos) << text;
}

// An existing part is done, whatever the queue still says of its task.
TEST(JobStatus, WhatIsThereCounts) {
  Queue queue;
  queue.tasks[0] = {true, "COMPLETING", "None", 4};
  const JobStatus status = status_of(job_of(1), {}, {true}, queue, "", {});
  EXPECT_EQ(status.done.size(), 1u);
  EXPECT_TRUE(status.running.empty());
}

// A task with many units works on the first one without a part.
TEST(JobStatus, OneUnitOfATaskRuns) {
  const Job job = job_of(2500);
  std::vector<bool> done(2500, true);
  for (const int unit : {7, 1007, 2007}) done[static_cast<std::size_t>(unit)] = unit == 7;
  Queue queue;
  queue.tasks[7] = {true, "RUNNING", "None", 100};
  const JobStatus status = status_of(job, {}, done, queue, "", 10.0);
  EXPECT_EQ(status.running, (std::set<int>{1007}));
  EXPECT_EQ(status.waiting, (std::set<int>{2007}));
  EXPECT_TRUE(status.reasons.empty());
}

TEST(JobStatus, WithoutSlurmItTellsWhatItSees) {
  const Job job = job_of(3);
  const JobStatus status = status_of(job, {}, {true, false, false}, {}, "`squeue`: gone", 10.0);
  EXPECT_EQ(status.unknown, (std::set<int>{1, 2}));
  EXPECT_TRUE(status.lost.empty());
  EXPECT_NE(to_text(job, status, noon).find("Slurm does not answer, so it is not known what runs (`squeue`: gone)"),
            std::string::npos);
}

TEST(JobStatus, TellsWhatToDoWhereNothingGoesOn) {
  const Job job = job_of(2);
  const std::string lost = to_text(job, status_of(job, {}, {true, false}, Queue{}, "", {}), noon);
  EXPECT_NE(lost.find("`penumbra farm collect` finishes it"), lost.npos) << lost;
  JobState state;
  state.finished = {0};
  state.resubmissions = 2;
  const std::string merged = to_text(job, status_of(job, state, {true, true}, Queue{}, "", {}), noon);
  EXPECT_NE(merged.find("resubmissions: 2\nfinished: /a0.exr\n"), merged.npos) << merged;
}

class FarmStatus : public FarmTest {};

TEST_F(FarmStatus, ReadsFolderAndQueue) {
  ASSERT_EQ(submit({"--shards", "4"}), 0) << said();
  const std::string name = job().name;
  ASSERT_EQ(run_task(0).exit_code, 0);
  set_queue(name + "|101|1|RUNNING|0:01|None\n" + name + "|101|2|PENDING|0:00|Priority\n");
  const auto json = status();
  EXPECT_EQ(json.at("done"), 1);
  EXPECT_EQ(json.at("running"), std::vector<int>{1});
  EXPECT_EQ(json.at("waiting"), std::vector<int>{2});
  EXPECT_EQ(json.at("lost"), std::vector<int>{3});
  EXPECT_TRUE(json.at("slurm"));
  EXPECT_GT(json.at("seconds_left"), 0);

  put_program("squeue", "echo 'Unable to contact slurm controller' >&2\nexit 1\n");
  const auto silent = status();
  EXPECT_FALSE(silent.at("slurm"));
  EXPECT_EQ(silent.at("done"), 1);
  EXPECT_EQ(silent.at("unknown"), (std::vector<int>{1, 2, 3}));
}

// A truncated part is not done.
TEST_F(FarmStatus, NoticesATornPart) {
  ASSERT_EQ(submit({"--shards", "2"}), 0) << said();
  ASSERT_EQ(run_task(0).exit_code, 0);
  const std::string part = folder().part(job(), 0, 1).string();
  put_content(part, content_of(part).substr(0, 5000));
  EXPECT_EQ(status().at("lost"), (std::vector<int>{0, 1}));
}

TEST_F(FarmStatus, FindsTheJobByFolderPictureOrScene) {
  ASSERT_EQ(submit({"--shards", "2"}), 0) << said();
  EXPECT_EQ(farm({"status", folder().path().string()}), 0) << said();
  EXPECT_EQ(farm({"status", output_}), 0) << said();
  EXPECT_EQ(farm({"status", scene_file_}), 0) << said();
  EXPECT_EQ(farm({"status", output_ + "x"}), 66);
  ASSERT_EQ(farm({"submit", scene_file_, "-o", (work_ / "other.exr").string(), "--shards", "1"}), 0) << said();
  EXPECT_EQ(farm({"status", scene_file_}), 66);
  EXPECT_NE(said().find("has several jobs"), std::string::npos) << said();
}

TEST_F(FarmStatus, DamagedFolder) {
  ASSERT_EQ(submit({"--shards", "2"}), 0) << said();
  const std::string manifest = folder().manifest().string(), whole = content_of(manifest);
  for (const std::string& text : {whole.substr(0, whole.size() / 2), std::string("[]"), std::string("{}"),
                                  std::string(), std::string("{\"format\": 2}")}) {
    put_content(manifest, text);
    EXPECT_EQ(farm({"status", output_}), 65);
    EXPECT_NE(said().find("is damaged or was not written by `penumbra farm`"), std::string::npos) << said();
  }
}

}  // namespace
}  // namespace penumbra::test
