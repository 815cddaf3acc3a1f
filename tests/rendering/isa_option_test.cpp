// `penumbra render --isa` as users call it: what runs, what it refuses, and that the picture is the same.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/render/render_command.hpp"
#include "base/command_line.hpp"
#include "base/test_folder.hpp"
#include "rendering/isa.hpp"

namespace penumbra {
namespace {

class IsaOption : public testing::Test {
 protected:
  IsaOption() {
    std::ofstream(scene_) << "image_size 20 20\nrays_per_pixel 2\nbackground 0.1 0.1 0.1\n"
                             "disk_light 1 5 0 1 0 1 0 1 1 1\nsphere 1 0.1 0.2 -4\n";
  }

  // The exit code of a render into `picture_`.
  int render(const std::vector<std::string>& arguments) {
    const std::vector<std::string> fixed = {"render", scene_, "-o", picture_, "--stats", stats_, "--quiet"};
    return render_command(test::parse_command(render_subcommand, test::command_line(fixed, arguments)));
  }

  // The error message about `--isa name`; empty if there is none.
  std::string problem(const std::string& name) {
    try {
      EXPECT_EQ(render({"--isa", name}), 0) << name;
      return "";
    } catch (const test::WrongUse& e) {
      return e.what();
    }
  }

  std::string isa_used() const { return nlohmann::json::parse(std::ifstream(stats_))["isa"].get<std::string>(); }

  test::TestFolder folder_;
  std::string scene_ = folder_ / "scene.cli", picture_ = folder_ / "out.exr", stats_ = folder_ / "stats.json";
};

TEST_F(IsaOption, IsTheWidestWithoutAWord) {
  ASSERT_EQ(render({}), 0);
  EXPECT_EQ(isa_used(), usable_kernels().back()->isa);
}

TEST_F(IsaOption, RunsTheOneAskedForIntoTheSameFile) {
  ASSERT_EQ(render({}), 0);
  const std::string file = test::content_of(picture_);
  for (const Kernel* kernel : usable_kernels()) {
    ASSERT_EQ(render({"--isa", kernel->isa}), 0);
    EXPECT_EQ(isa_used(), kernel->isa);
    EXPECT_EQ(test::content_of(picture_), file) << kernel->isa;
  }
}

TEST_F(IsaOption, SaysWhichThereAre) {
  for (const char* name : {"sse42", "avx2", "avx512", "AVX2", "neon", ""}) {
    const std::string said = problem(name);
    EXPECT_EQ(said.empty(), kernel_from_name(usable_kernels(), name) != nullptr) << said;
    if (said.empty()) continue;
    for (const Kernel* kernel : usable_kernels()) EXPECT_NE(said.find(kernel->isa), std::string::npos) << said;
    const bool known = std::find(std::begin(isa_names), std::end(isa_names), std::string(name)) != std::end(isa_names);
    const char* reason = !known                                     ? "no instruction set"
                         : !kernel_from_name(built_kernels(), name) ? "not built for"
                                                                    : "cannot run";
    EXPECT_NE(said.find(reason), std::string::npos) << said;
  }
}

// From the shell.
TEST_F(IsaOption, IsAUsageError) {
  const std::string command = std::string(PENUMBRA_PROGRAM) + " render " + scene_ + " -o " + picture_ + " --isa neon";
  const test::ProgramResult result = test::run_program(command);
  EXPECT_EQ(result.exit_code, 64) << result.output;
  EXPECT_NE(result.output.find("there is no instruction set `neon`; there are "), std::string::npos) << result.output;
  EXPECT_FALSE(std::filesystem::exists(picture_));
}

// Built kernels have known names, in their order; usable kernels are built kernels.
TEST(Isa, KernelsHaveTheNamesThereAre) {
  std::size_t next = 0;
  for (const Kernel* kernel : built_kernels()) {
    while (next < std::size(isa_names) && kernel->isa != std::string_view(isa_names[next])) next++;
    EXPECT_LT(next++, std::size(isa_names)) << kernel->isa;
  }
  for (const Kernel* kernel : usable_kernels()) EXPECT_NE(kernel_from_name(built_kernels(), kernel->isa), nullptr);
}

}  // namespace
}  // namespace penumbra
