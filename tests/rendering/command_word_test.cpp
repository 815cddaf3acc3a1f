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

TEST(CommandWord, AnUnknownOptionOffersTheNearOne) {
  for (const auto& [words, answer] : std::vector<std::pair<std::string, std::string>>{
           {"render --ray 5 scene.cli", "`--ray`; did you mean `--rays`?"},
           {"render scene.cli --ray=5", "`--ray`; did you mean `--rays`?"},
           {"render scene.cli -rays 5", "`-rays`; did you mean `--rays`?"},
           {"check --coarse scene.cli", "`--coarse`; did you mean `--course`?"},
           {"compare --heat-map a b", "`--heat-map`; did you mean `--heatmap`?"},
           {"farm submit --shard 5 scene.cli", "`--shard`; did you mean `--shards`?"},
           {"--versio", "`--versio`; did you mean `--version`?"},
           {"render scene.cli --paint", "`--paint`; --help lists the options"}}) {
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 64) << words;
    EXPECT_EQ(result.output, "penumbra: there is no option " + answer + "\n") << words;
  }
}

TEST(CommandWord, AnEmptyValueIsAnError) {
  for (const std::string words : {"render --stats= -o x.png", "render --stats= scene.cli",
                                  "render scene.cli --course=", "compare --heatmap= a b", "view --window= scene.cli"}) {
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 64) << words;
    EXPECT_NE(result.output.find("=: its value is empty\n"), std::string::npos) << result.output;
  }
  for (const std::string words :
       {"render scene.cli --stats ''", "render scene.cli -o ''", "render ''", "render scene.cli --checkpoint ''"}) {
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 64) << words;
    EXPECT_NE(result.output.find(": its value is empty\n"), std::string::npos) << result.output;
  }
}

TEST(CommandWord, NumbersAreDecimal) {
  const std::vector<std::string> options = {"render scene.cli --rays ",      "render scene.cli --seed ",
                                            "render scene.cli --max-depth ", "render scene.cli --threads ",
                                            "render scene.cli --frames ",    "samples --json -n "};
  for (const std::string& option : options) {
    for (const std::string number : {"0x10", "0X10", "0b1", "1e1x", "' 10'", "+10", "1_0"}) {
      const ProgramResult result = run(option + number);
      EXPECT_EQ(result.exit_code, 64) << option << number << result.output;
      EXPECT_NE(result.output.find("expected"), std::string::npos) << option << number << result.output;
    }
  }
  const ProgramResult ten = run("samples --json -n 010");
  EXPECT_EQ(ten.exit_code, 0);
  EXPECT_NE(ten.output.find("\"n\": 10,"), std::string::npos) << ten.output;
  EXPECT_EQ(run("samples --json -n 10").output, ten.output);
}

}  // namespace
}  // namespace penumbra::test
