// Limits that keep any input from exhausting the machine.
#include <fmt/format.h>

#include "support.hpp"

namespace penumbra {
namespace {

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; i++) all += text;
  return all;
}

TEST(Limits, ofThePictureSize) {
  EXPECT_EQ(told("image_size 65537 1\n"),
            "s.cli:1:12: error: `w` of `image_size` has to be a whole number from 1 to 65536; found `65537`\n"
            "  image_size 65537 1\n             ^~~~~\n");
  EXPECT_EQ(told("image_size 1 0\n"),
            "s.cli:1:14: error: `h` of `image_size` has to be a whole number from 1 to 65536; found `0`\n"
            "  image_size 1 0\n               ^\n");
  EXPECT_EQ(told("image_size 65536 4097\n"),
            "s.cli:1:12: error: a picture of 65536 x 4097 pixels is too large; at most 268435456 pixels are allowed\n"
            "  image_size 65536 4097\n             ^~~~~\n");
  EXPECT_EQ(scene_of(light + ball + "image_size 65536 4096\n").settings.height, 4096);
}

TEST(Limits, ofTheRays) {
  EXPECT_EQ(scene_of(light + ball + "rays_per_pixel 16777216\n").settings.rays_per_pixel, 16777216);
  EXPECT_EQ(read("rays_per_pixel 16777217\n").diagnostics.at(0).message,
            "`n` of `rays_per_pixel` has to be a whole number from 1 to 16777216; found `16777217`");
}

TEST(Limits, ofNestedGroups) {
  EXPECT_EQ(told(light + repeated("begin_list\n", 64) + ball + repeated("end_list\n", 64)), "");
  EXPECT_EQ(told(light + repeated("begin_list\n", 65) + ball + repeated("end_list\n", 64)),
            "s.cli:66:1: error: groups nest more than 64 deep\n  begin_list\n  ^~~~~~~~~~\n");
}

TEST(Limits, ofNestedInstances) {
  std::string text = light + ball + "named_object n0\n";
  for (int i = 0; i < 64; i++) text += fmt::format("instance n{}\nnamed_object n{}\n", i, i + 1);
  EXPECT_EQ(read(text + "instance n63\n").diagnostics.size(), 1u) << "only that n64 is not used";
  EXPECT_EQ(told(text + "instance n64\n"),
            "s.cli:132:1: error: groups and instances nest more than 64 deep\n  instance n64\n  ^~~~~~~~\n");
}

TEST(Limits, ofInstancesAndGroupsTogether) {
  std::string text = light + ball + "named_object n0\n";
  for (int i = 0; i < 32; i++) {
    text += fmt::format("begin_list\ninstance n{}\nend_list\nnamed_object n{}\n", i, i + 1);
  }
  EXPECT_NE(told(text + "instance n32\n").find("groups and instances nest more than 64 deep"), std::string::npos);
  EXPECT_EQ(told(text + "instance n31\n").find("error"), std::string::npos);
}

TEST(Limits, forgetWhatWasNamedAway) {
  // The deep group is named, so the group around it is no longer deep.
  const std::string deep = repeated("begin_list\n", 60) + ball + repeated("end_list\n", 60) + "named_object deep\n";
  EXPECT_EQ(
      told(light + "begin_list\n" + ball + deep + "end_list\nnamed_object flat\nbegin_list\ninstance flat\nend_list\n" +
           "named_object a\nbegin_list\ninstance a\nend_list\nnamed_object b\ninstance b\ninstance deep\n"),
      "");
}

TEST(Limits, ofOpenPushes) {
  EXPECT_EQ(told(light + ball + repeated("push\n", 4096) + repeated("pop\n", 4096)), "");
  EXPECT_EQ(told(repeated("push\n", 4097) + repeated("pop\n", 4096)),
            "s.cli:4097:1: error: more than 4096 `push` are open\n  push\n  ^~~~\n");
}

TEST(Limits, ofNestedReads) {
  Files files;
  for (int i = 1; i < 80; i++) files[fmt::format("f{}", i)] = fmt::format("read f{}\n", i + 1);
  files["f63"] = ball;
  EXPECT_EQ(told(light + "read f1\n", {}, files), "");
  files["f63"] = "read f64\n";
  EXPECT_EQ(told(light + "read f1\n", {}, files),
            "f63:1:1: error: files read each other more than 64 deep\n  read f64\n  ^~~~\n");
}

TEST(Limits, ofReadsThatDoubleAtEveryLevel) {
  Files files;
  for (int i = 1; i < 40; i++) files[fmt::format("f{}", i)] = repeated(fmt::format("read f{}\n", i + 1), 2);
  files["f40"] = "";
  const SceneFile file = read("read f1\n", {}, files);
  ASSERT_FALSE(file.diagnostics.empty());
  EXPECT_EQ(file.diagnostics[0].message, "the scene opens more than 65536 files");
}

TEST(Limits, ofAllBytesTogether) {
  Limits limits;
  EXPECT_EQ(limits.bytes, 4294967296u);
  limits.bytes = 100'000;
  const Files files{{"s.cli", repeated("read b.cli\n", 10)}, {"b.cli", std::string(10'000, ' ')}};
  const SceneFile file = read_scene_with("s.cli", std::nullopt, {}, in_memory(files), limits);
  ASSERT_EQ(file.diagnostics.size(), 1u);
  EXPECT_EQ(file.diagnostics[0].message, "the files of the scene have more than 100000 bytes");
  EXPECT_EQ(file.diagnostics[0].line, 10);
}

TEST(Limits, ofPicturesOfManyObjects) {
  Limits limits;
  limits.copies = 10'000;
  const Files files{{"s.cli", light + repeated(ball, 1'000) + repeated("render\neye 0 0 1\n", 100)}};
  const SceneFile file = read_scene_with("s.cli", std::nullopt, {}, in_memory(files), limits);
  ASSERT_FALSE(file.diagnostics.empty());
  EXPECT_EQ(file.diagnostics[0].message, "too many pictures of too many objects in one file");
  EXPECT_EQ(file.diagnostics[0].line, 1 + 1'000 + 1 + 2 * 9);
  EXPECT_EQ(pictures(read(light + ball + repeated("render\n", 1'000))).size(), 1'000u);
}

}  // namespace
}  // namespace penumbra
