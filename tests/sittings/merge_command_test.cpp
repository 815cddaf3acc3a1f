// `penumbra merge` as users call it: writes the file of a single render, or says what is wrong and writes nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

class Merge : public SittingTest {
 protected:
  std::string part(int index) const { return path("part" + std::to_string(index) + ".exr"); }

  Words shards(int count, const Words& arguments) const {
    Words names;
    for (int i = 0; i < count; i++) {
      names.push_back(part(i));
      EXPECT_EQ(render(arguments + Words{"--shard", std::to_string(i) + "/" + std::to_string(count), "-o", part(i)}), 0)
          << said();
    }
    return names;
  }
  int merge(const Words& parts, const std::string& output) const {
    return run(Words{"merge", "--quiet", "-o", output} + parts);
  }
};

TEST_F(Merge, GivesTheFileOfASingleRender) {
  const Words layers = {"--aov", "depth,normal,albedo,variance,samples"};
  for (const Words& arguments : {Words{"--rays", "5"} + layers, Words{"--noise", "0.05"} + layers,
                                 Words{"--rays", "3", "--crop", "5,7,39,30"} + layers,
                                 Words{"--noise", "0.05", "--crop", "5,7,39,30"} + layers}) {
    Words parts = shards(4, arguments);
    std::swap(parts[0], parts[2]);
    ASSERT_EQ(merge(parts, picture_), 0) << said();
    EXPECT_TRUE(content_of(picture_) == unbroken(arguments).first);
  }
}

// What comes after the film is the same, too: painted rectangles, bits, the course's rounding.
TEST_F(Merge, DevelopsAsTheSingleRenderDoes) {
  put_content(scene_, scene_text(4) + "color 1 .5 .25\nrect 3 4 20 9\n");
  for (const Words& arguments : {Words{"--bits", "16"}, Words{"--course"}}) {
    const Words parts = shards(3, arguments);
    const std::string png = path("picture.png");
    ASSERT_EQ(merge(parts, png), 0) << said();
    EXPECT_TRUE(content_of(png) == unbroken(arguments, ".png").first);
  }
}

TEST_F(Merge, ManyFilesAtOnce) {
  const Words parts = shards(2, {});
  EXPECT_EQ(run(Words{"merge", "-o", picture_, "-o", path("picture.png")} + parts), 0);
  EXPECT_NE(said().find("picture.png: 53x37 pixels, from 2 parts"), std::string::npos) << said();
  EXPECT_TRUE(std::filesystem::exists(picture_));
}

TEST_F(Merge, NamesWhatIsWrongAndWritesNothing) {
  const Words good = shards(5, {"--rays", "2"});
  put_content(picture_, "old");
  const auto problem = [&](const Words& parts, int code = 65) {
    EXPECT_EQ(merge(parts, picture_), code) << said();
    EXPECT_EQ(content_of(picture_), "old");
    return said();
  };
  EXPECT_EQ(problem({good[0], good[4]}), "penumbra: of 5 shards, numbered from 0, 3 are missing: 1-3\n");
  EXPECT_EQ(problem(good + Words{good[3]}),
            "penumbra: shard 3 occurs twice: `" + good[3] + "` and `" + good[3] + "`\n");
  EXPECT_EQ(problem(good + Words{path("none.exr")}, 66),
            "penumbra: cannot open `" + path("none.exr") + "`: No such file or directory\n");

  const std::string other = path("other.exr");
  ASSERT_EQ(render({"--rays", "3", "--shard", "1/5", "-o", other}), 0);
  EXPECT_EQ(problem({good[0], other, good[2], good[3], good[4]}),
            "penumbra: `" + other + "` is a part of another picture: its `rays` is 3, but 2 in the others\n" +
                "penumbra: of 5 shards, numbered from 0, one is missing: 1\n");

  ASSERT_EQ(render({"-o", other}), 0);
  EXPECT_EQ(problem(good + Words{other}),
            "penumbra: `" + other + "` is not a part of a picture, as `penumbra render --shard` writes them\n");

  const std::string whole = content_of(good[1]);
  put_content(good[1], whole.substr(0, whole.size() - 100));
  EXPECT_NE(problem(good).find("penumbra: `" + good[1] + "` is a truncated part of a picture: its end is missing\n"),
            std::string::npos);
  std::string damaged = whole;
  damaged[damaged.size() - 1000] ^= 1;
  put_content(good[1], damaged);
  EXPECT_NE(problem(good).find("penumbra: `" + good[1] + "` is a damaged part of a picture: block "),
            std::string::npos);
}

// Wherever a part is truncated or changed, it is noticed, except in the preview, which does not count.
TEST_F(Merge, NoticesDamageAnywhere) {
  put_content(scene_, "image_size 20 12\nbackground .3 .4 .5\n");
  const Words parts = shards(2, {});
  const std::string whole = content_of(parts[0]);
  const std::size_t start = whole.find("PENUMBRA");
  ASSERT_NE(start, std::string::npos);
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 40) {
    put_content(parts[0], whole.substr(0, size));
    ASSERT_EQ(merge(parts, picture_), 65) << size;
  }
  for (std::size_t i = start; i < whole.size(); i += whole.size() / 40) {
    std::string bad = whole;
    bad[i] ^= 4;
    put_content(parts[0], bad);
    ASSERT_EQ(merge(parts, picture_), 65) << i;
  }
  EXPECT_FALSE(std::filesystem::exists(picture_));
}

// A viewer of EXR files shows a part: one pixel for each tile.
TEST_F(Merge, PartsAreExrFiles) {
  if (!have_program("oiiotool")) GTEST_SKIP() << "oiiotool (openimageio-tools) is not installed";
  const Words parts = shards(2, {});
  const ProgramResult info = run_program("oiiotool --info --stats " + parts[0]);
  EXPECT_EQ(info.exit_code, 0) << info.output;
  EXPECT_NE(info.output.find("7 x    5, 3 channel, float openexr"), std::string::npos) << info.output;
}

TEST_F(Merge, WrongWords) {
  EXPECT_EQ(run({"merge", "-o", picture_}), 64);
  EXPECT_EQ(run({"merge", part(0)}), 64);
  EXPECT_EQ(run({"merge", part(0), "-o", path("picture.jpg")}), 64);
}

}  // namespace
}  // namespace penumbra::test
