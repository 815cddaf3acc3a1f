// How the program answers a word that it does not know on its command line.
#include <gtest/gtest.h>

#include "base/test_folder.hpp"

namespace penumbra::test {
namespace {

ProgramResult run(const std::string& words) { return run_program(PENUMBRA_PROGRAM " " + words + " 2>&1"); }

TEST(CommandWord, NearOnesAreNamed) {
  const ProgramResult result = run("rendr scene.cli");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_EQ(result.output, "penumbra: there is no command `rendr`; did you mean `render`?\n");
}

TEST(CommandWord, AlsoOfTheFarm) {
  const ProgramResult result = run("farm submot scene.cli");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_EQ(result.output, "penumbra: there is no command `submot`; did you mean `submit`?\n");
}

TEST(CommandWord, OthersGetTheList) {
  const ProgramResult result = run("paint");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_EQ(result.output,
            "penumbra: there is no command `paint`; the commands are render, check, compare, samples, merge, farm, "
            "view\n");
}

TEST(CommandWord, ASceneAloneIsNotEnough) {
  const ProgramResult result = run("scene.cli");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_EQ(result.output, "penumbra: `penumbra render scene.cli -o OUT.png` renders a scene\n");
}

TEST(CommandWord, AWrongYearIsToldOnce) {
  const ProgramResult result = run("render scene.cli -o OUT.png --course=2016");
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_EQ(result.output,
            "--course: there is no course of `2016`; there are 2015, 2017, 2018, 2022\n"
            "Run with --help for more information.\n");
}

}  // namespace
}  // namespace penumbra::test
