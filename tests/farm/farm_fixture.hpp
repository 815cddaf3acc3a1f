// A scene in a folder with a difficult name, and fakes of Slurm's commands: `sbatch` records its arguments and returns
// ids from 101 on, `squeue` prints what the test sets, `scontrol` records its arguments.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "farm/job.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {

class FarmTest : public SittingTest {
 protected:
  FarmTest() {
    std::filesystem::create_directories(tools_);
    std::filesystem::create_directories(work_);
    put_content(scene_file_, scene_text(4));
    put_program("sbatch",
                "printf '%s\\n' \"$@\" -- >> \"$TOOLS/sbatch.log\"\n"
                "echo $((101 + $(grep -c -x -e -- \"$TOOLS/sbatch.log\") - 1))\n");
    put_program("squeue", "cat \"$TOOLS/queue\"\n");
    put_program("scontrol", "echo \"$@\" >> \"$TOOLS/scontrol.log\"\n");
    put_program("sinfo", "echo 'render*|0/6/0/6'\n");
    set_queue("");
  }

  void put_program(const std::string& name, const std::string& text) const {
    const std::filesystem::path program = tools_ / name;
    put_content(program, "#!/bin/bash\n" + text);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  void set_queue(const std::string& lines) const { put_content(tools_ / "queue", lines); }

  std::vector<std::pair<std::string, std::string>> environment() const {
    return {{"PATH", tools_.string() + ":/usr/bin:/bin"}, {"TOOLS", tools_.string()}};
  }

  // Runs `farm ARGUMENTS...`; its output is then in said().
  int farm(const Words& arguments) const { return run(Words{"farm"} + arguments, environment()); }
  int submit(const Words& arguments = {}) const {
    return farm(Words{"submit", scene_file_, "-o", output_, "--size", "53x37"} + arguments);
  }
  int collect(const Words& arguments = {}) const { return farm(Words{"collect", output_} + arguments); }
  nlohmann::json status() const {
    EXPECT_EQ(farm({"status", output_, "--json"}), 0) << said();
    return nlohmann::json::parse(said());
  }

  Job job() const { return folder().read_job(); }
  JobFolder folder() const { return JobFolder(output_ + ".farm"); }

  // Runs a task as a scheduler other than Slurm would.
  ProgramResult run_task(int task, const std::string& before = {}) const {
    return run_program(before + " bash " + quoted(folder().shard_script().string()) + " " + std::to_string(task));
  }
  void run_all_tasks() const {
    for (int task = 0; task < job().tasks(); task++) {
      const ProgramResult result = run_task(task);
      EXPECT_EQ(result.exit_code, 0) << result.output;
    }
  }

  // Quotes a word for the shell of the tests, by other means than the program does.
  static std::string quoted(const std::string& text) {
    std::string word = "\"";
    for (const char letter : text) {
      if (std::string("\"\\$`").find(letter) != std::string::npos) word += '\\';
      word += letter;
    }
    return word + "\"";
  }

  std::string single_machine(const Words& arguments = {}) const {
    const std::string file = (work_ / "single.exr").string();
    EXPECT_EQ(run(Words{"render", scene_file_, "-o", file, "--quiet", "--size", "53x37"} + arguments), 0) << said();
    return content_of(file);
  }

  // The arguments of sbatch, one per line, and a line -- after each call.
  std::string submissions() const { return content_of(tools_ / "sbatch.log"); }

  const std::filesystem::path tools_ = folder_ / "tools";
  const std::filesystem::path work_ = folder_ / "it's 100% \"odd\" $HOME `x` \\ & ;";
  const std::string scene_file_ = (work_ / "a scene's.cli").string();
  const std::string output_ = (work_ / "the 'picture'.exr").string();
};

}  // namespace penumbra::test
