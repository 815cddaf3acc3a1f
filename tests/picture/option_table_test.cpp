// Properties of every row of the table of options, so that a new option cannot be forgotten anywhere.
#include "picture/option_table.hpp"
#include "app/options/shared_options.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "app/options/render_options.hpp"
#include "base/command_line.hpp"
#include "base/test_folder.hpp"
#include "picture/reference_pages.hpp"
#include "picture/scene_lines.hpp"
#include "rendering/render_text.hpp"

namespace penumbra {
namespace {

// Has everything that an option can change.
const std::string scene_text = R"(lens 0.2 5
shutter 0 0.5
disk_light 2 5 -2 1 0 -1 0 1 1 1
glossy 0.8 0.1 0.1 0.3 0.3 0.3 10 0.3 0.1
sphere 1 -1 0 -5
translucent 0.1 0.1 0.8 0.3 0.3 0.3 10 0.1 0.05 0.6 1.1 0.3
sphere 1 1 0 -4
surface 1 1 1 0 0 0 1 1 1 10 0
sphere 1 0 3 -9
)";

// For each option, texts that ask for something other than `scene_text` and the defaults.
const std::map<std::string_view, std::vector<std::string>> examples = {
    {"size", {"640x480", "1x65536"}},
    {"rays", {"2", "16777216"}},
    {"sampler", {"regular", "random", "bluenoise"}},
    {"filter", {"triangle", "gaussian"}},
    {"seed", {"1", "4294967295"}},
    {"max-depth", {"0", "100"}},
    {"branching", {"full"}},
    {"reflection-rays", {"2", "65536"}},
    {"transmission-rays", {"3"}},
    {"shadow-rays", {"4"}},
    {"light-rays", {"0", "1"}},
    {"sampler-light", {"regular"}},
    {"crop", {"1,2,30,40"}},
    {"noise", {"0.01", "1e-05", "1"}},
    {"first-rays", {"16", "65536"}},
    {"shutter", {"-0.5,0.25", "0.1,0.1"}},
    {"time", {"0.1", "-1000000"}},
    {"frames", {"0-0", "5", "3-17", "3-17x4"}},
    {"frame", {"0", "999999"}},
    {"eye", {"0,1.5,4", "-1e-05,0,12"}},
    {"uvw", {"0,0,-1,0,1,0,1,0,0", "0.6,0,-0.8,0,1,0,0.8,0,0.6"}},
    {"lens", {"0,5", "0.1,0.30000000000000004"}},
    {"disk-radius", {"0", "1:0.25", "0.5,1:0.25"}},
    {"gloss", {"0", "1:0.25", "0.5,2:0.25,1:0"}},
    {"blur", {"0", "2:0.25"}},
    {"without", {"lens", "antialiasing,motion", "antialiasing,lens,motion,disk-lights,gloss,translucency"}},
    {"exposure", {"-1.5", "20"}},
    {"course", {"yes", "2015", "2018"}},
    {"highlight", {"phong"}},
    {"lenient", {"yes"}},
    {"no-shadows", {"yes"}},
    {"lens-model", {"cone"}},
    {"transparent-shadows", {"yes"}},
    {"aov", {"depth", "depth,normal,albedo,variance,samples"}},
    {"bits", {"16"}},
};

PictureOptions parsed(const PictureOption& row, const std::string& text) {
  PictureOptions options;
  EXPECT_EQ(parse_option(row, options, text), "") << row.name << ' ' << text;
  return options;
}

template <class Check>
void for_each_example(const Check& check) {
  for (const PictureOption& row : option_table()) {
    const auto found = examples.find(row.name);
    ASSERT_NE(found, examples.end()) << "give an example of --" << row.name;
    for (const std::string& text : found->second) check(row, text);
  }
}

TEST(OptionTable, WordsAskForTheSameAgain) {
  const Scene scene = test::scene_from(scene_text);
  for_each_example([&](const PictureOption& row, const std::string& text) {
    const PictureOptions options = parsed(row, text);
    EXPECT_NE(options, PictureOptions{}) << row.name << ' ' << text << " asks for nothing";
    const std::string words = row.words(options, with_options(scene, options).settings);
    EXPECT_EQ(parsed(row, words), options) << row.name << ": " << text << " became " << words;
  });
}

TEST(OptionTable, NothingIsSaidOfWhatWasNotAskedFor) {
  const Scene scene = test::scene_from(scene_text);
  const std::set<std::string_view> always = {"size", "rays", "sampler", "seed", "max-depth"};
  for (const PictureOption& row : option_table()) {
    EXPECT_EQ(row.words({}, scene.settings).empty(), !always.contains(row.name)) << row.name;
  }
}

TEST(OptionTable, WhatAPictureAsksForIsInItsMetadataAndItsKey) {
  const Scene scene = test::scene_from(scene_text);
  for_each_example([&](const PictureOption& row, const std::string& text) {
    const PictureOptions options = parsed(row, text);
    const Scene changed = with_options(scene, options);
    const auto tells = [&](const auto& entries) {
      return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == row.name; });
    };
    EXPECT_EQ(tells(metadata_for("a.cli", changed, options)), row.use < OptionUse::sums_only) << row.name;
    EXPECT_EQ(tells(plan_in_words(changed, options)), row.use < OptionUse::output_only) << row.name;
  });
}

TEST(OptionTable, NoOptionIsDroppedFromTheLinesOfTheWindow) {
  const Scene scene = test::scene_from(scene_text);
  for_each_example([&](const PictureOption& row, const std::string& text) {
    if (row.name == "frame") return;  // it does nothing without --frames
    const std::string lines = changed_lines(scene, parsed(row, text));
    EXPECT_NE(lines, "") << "--" << row.name << ' ' << text << " is dropped";
    if (row.command.empty() && row.name != "without") {
      EXPECT_NE(lines.find("# --" + std::string(row.name)), lines.npos) << lines;
    }
  });
}

// The lines are scene language: appended to the scene, they give the same settings as the options.
TEST(OptionTable, TheLinesOfTheWindowAreTheSceneLanguage) {
  const Scene scene = test::scene_from(scene_text);
  for_each_example([&](const PictureOption& row, const std::string& text) {
    if (row.command.empty() || row.command.find("...") != row.command.npos) return;
    const PictureOptions options = parsed(row, text);
    const Scene wanted = with_options(scene, options);
    const std::string lines = changed_lines(scene, options);
    if (lines.find("# ") != lines.npos) return;  // of a command that cannot stand at the end
    const Scene read = test::scene_from(scene_text + lines);
    EXPECT_TRUE(read.settings == wanted.settings) << row.name << ' ' << text;
    EXPECT_EQ(read.camera.lens_radius, wanted.camera.lens_radius) << row.name;
    EXPECT_EQ(read.camera.focus_distance, wanted.camera.focus_distance) << row.name;
    EXPECT_EQ(read.camera.eye, wanted.camera.eye) << row.name;
    EXPECT_EQ(read.camera.right, wanted.camera.right) << row.name;
    EXPECT_EQ(read.camera.up, wanted.camera.up) << row.name;
    EXPECT_EQ(read.camera.back, wanted.camera.back) << row.name;
    EXPECT_EQ(read.camera.shutter_open, wanted.camera.shutter_open) << row.name;
    EXPECT_EQ(read.camera.shutter_close, wanted.camera.shutter_close) << row.name;
  });
}

TEST(OptionTable, KnobsSetWhatTheyShow) {
  const Scene scene = test::scene_from(scene_text);
  for (const PictureOption& row : option_table()) {
    if (!row.knobs) continue;
    const std::vector<Knob> knobs = row.knobs(scene, {});
    ASSERT_FALSE(knobs.empty()) << row.name;
    for (std::size_t i = 0; i < knobs.size(); i++) {
      PictureOptions options;
      const double wanted = knobs[i].kind == Knob::Kind::toggle ? 0 : knobs[i].value + 1;
      knobs[i].set(options, wanted);
      const Scene changed = with_options(scene, options);
      EXPECT_EQ(row.knobs(changed, options)[i].value, wanted) << knobs[i].label;
    }
  }
}

TEST(OptionTable, TheCommandLineTakesEveryRow) {
  for_each_example([&](const PictureOption& row, const std::string& text) {
    std::vector<std::string> words = {"render", "a.cli", "-o", "a.exr", "--" + std::string(row.name)};
    if (row.value_is_optional && text != "yes") words.back() += "=" + text;
    if (!row.metavar.empty() && !row.value_is_optional) words.push_back(text);
    if (row.name == "frame") words.insert(words.end(), {"--frames", "0-999999"});
    if (row.name == "noise") words.insert(words.end(), {"--rays", "4"});
    if (row.name == "first-rays") words.insert(words.end(), {"--noise", "0.1"});
    PictureOptions asked = test::parse_command(render_subcommand, words);
    if (row.name == "frame") asked.frames.reset();
    if (row.name == "noise") asked.rays.reset();
    if (row.name == "first-rays") asked.noise.reset();
    EXPECT_EQ(asked, parsed(row, text)) << row.name << ' ' << text;
  });
}

TEST(OptionTable, TheReferencePageIsThatOfTheTable) {
  const std::string page = test::content_of(std::filesystem::path(PENUMBRA_ROOT) / "docs/options.md");
  EXPECT_TRUE(page == options_markdown(PENUMBRA_ROOT "/docs/templates/options.md"))
      << "`make docs` writes docs/options.md from the table";
  for (const PictureOption& row : option_table()) {
    EXPECT_NE(page.find("`--" + std::string(row.name)), page.npos) << row.name;
    EXPECT_TRUE(row.help.ends_with(']')) << row.name << " does not give its default in brackets";
  }
}

// `view --help` speaks of no option that `view` does not have.
TEST(OptionTable, TheHelpOfTheWindowIsTrueOfIt) {
  PictureOptions options;
  for (const CommandOption& option : picture_options(options, true)) {
    for (const PictureOption& row : option_table()) {
      const std::string name = "--" + std::string(row.name);
      if (row.use == OptionUse::everywhere) continue;
      EXPECT_NE(option.name, name);
      EXPECT_EQ(option.help.find(name), option.help.npos) << option.name << ": " << option.help;
    }
  }
}

TEST(OptionTable, WrongTextsAreRefusedWithASentence) {
  const std::map<std::string_view, std::vector<std::string>> wrong = {
      {"size", {"", "0x1", "640", "65537x1", "65536x65536", "640x480x2"}},
      {"rays", {"0", "16777217", "0x10", "1.5", "many", "-1", ""}},
      {"sampler", {"stars", ""}},
      {"seed", {"-1", "4294967296"}},
      {"max-depth", {"-1", "101"}},
      {"reflection-rays", {"0", "65537"}},
      {"crop", {"0,0,0,1", "1,1,1", "-1,0,1,1"}},
      {"noise", {"0", "nan", "2"}},
      {"first-rays", {"15", "65537", "x"}},
      {"shutter", {"1,0", "0", "0,inf"}},
      {"time", {"inf", "x", "1e7"}},
      {"frames", {"", "3x2", "3-", "4-3", "1-2x0", "-1-2", "0-1000000"}},
      {"eye", {"", "1,2", "1,2,3,4", "1,2,inf"}},
      {"uvw", {"1,0,0", "1,0,0,0,1,0,1,1,0", "1,0,0,0,1,0,0,0,x"}},
      {"lens", {"1", "-1,2", "1,0", "nan,1"}},
      {"gloss", {"-1", "0:1", "1:2:3", ""}},
      {"without", {"fog"}},
      {"exposure", {"0.25", "21"}},
      {"lens-model", {"thick"}},
      {"aov", {"height"}},
      {"bits", {"12"}},
      {"sampler-light", {"random"}},
  };
  for (const auto& [name, texts] : wrong) {
    for (const std::string& text : texts) {
      PictureOptions options;
      const std::string sentence = parse_option(option_named(name), options, text);
      EXPECT_NE(sentence.find("`" + text + "`"), sentence.npos) << name << ' ' << text << ": " << sentence;
    }
  }
}

}  // namespace
}  // namespace penumbra
