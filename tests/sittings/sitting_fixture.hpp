// A folder with a scene in it, and commands that render it.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "base/test_folder.hpp"
#include "base/test_scale.hpp"
#include "rendering/all_effects.hpp"
#include "sittings/running_program.hpp"

namespace penumbra::test {

using Words = std::vector<std::string>;

inline Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class SittingTest : public testing::Test {
 protected:
  SittingTest() { put_content(scene_, scene_text(16)); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // Runs `render SCENE arguments...`; its output is then in said().
  int render(const Words& arguments) const { return run(Words{"render", scene_, "--quiet"} + arguments); }
  int run(const Words& words, const std::vector<std::pair<std::string, std::string>>& environment = {}) const {
    return RunningProgram(words, log_, environment).wait();
  }
  std::string said() const { return content_of(log_); }
  // Runs a command of the shell in the folder; $P is the program.
  ProgramResult shell(const std::string& command) const { return shell_in(folder_.path().string(), command); }
  // The same, in another folder; the program ends after a minute at most, with 124.
  static ProgramResult shell_in(const std::string& folder, const std::string& command) {
    return run_program("cd '" + folder + "'; P='timeout 60 " PENUMBRA_PROGRAM "'; { " + command + "; }");
  }

  // The bytes of an unbroken render, and the seconds it took.
  std::pair<std::string, double> unbroken(const Words& arguments, const std::string& ending = ".exr") const {
    const auto start = std::chrono::steady_clock::now();
    const std::string file = path("unbroken" + ending);
    EXPECT_EQ(render(arguments + Words{"-o", file}), 0) << said();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::string bytes = content_of(file);
    EXPECT_FALSE(bytes.empty());
    std::filesystem::remove(file);
    return {std::move(bytes), seconds};
  }

  // The names of all files except scene and log.
  Words others() const {
    Words names = folder_.names();
    std::erase_if(names, [](const std::string& name) { return name == "scene.cli" || name == "log"; });
    return names;
  }

  TestFolder folder_;
  const std::string scene_ = path("scene.cli"), log_ = path("log");
  const std::string picture_ = path("picture.exr"), checkpoint_ = path("checkpoint");
};

}  // namespace penumbra::test
