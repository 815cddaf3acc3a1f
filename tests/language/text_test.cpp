#include <string>

#include "language/near_word.hpp"
#include "support.hpp"

namespace penumbra {
namespace {

TEST(Text, cutsLinesAndWords) {
  LineCursor cursor(
      "\xEF\xBB\xBF"
      "fov 60 # wide\r\n\n\t eye\t1  2 3#x\nlast");
  Line line;
  ASSERT_TRUE(cursor.next(line));
  EXPECT_EQ(line.number, 1);
  Words words = split_words(line.text);
  ASSERT_EQ(words.count, 2);
  EXPECT_EQ(words.word[1], "60");
  EXPECT_EQ(line.column_of(words.word[1]), 5u);
  ASSERT_TRUE(cursor.next(line));
  EXPECT_EQ(split_words(line.text).count, 0);
  ASSERT_TRUE(cursor.next(line));
  words = split_words(line.text);
  ASSERT_EQ(words.count, 4);
  EXPECT_EQ(words.word[3], "3");
  EXPECT_EQ(line.column_of(words.word[0]), 3u);
  ASSERT_TRUE(cursor.next(line));
  EXPECT_EQ(line.text, "last");
  EXPECT_EQ(line.number, 4);
  EXPECT_FALSE(cursor.next(line));
}

TEST(Text, countsWordsBeyondThoseItKeeps) {
  std::string text;
  for (int i = 0; i < 100; i++) text += "w ";
  EXPECT_EQ(split_words(text).count, 100);
}

TEST(Text, readsEveryKindOfLineEndAlike) {
  const std::string unix_text =
      light + "push\n translate 1 2 3\n sphere .5 0 0 -4 # ball\npop\n" + triangle + "write a.png\n";
  std::string windows_text = "\xEF\xBB\xBF";
  for (const char c : unix_text) windows_text += c == '\n' ? std::string("\r\n") : c == ' ' ? "\t" : std::string(1, c);
  windows_text.resize(windows_text.size() - 2);
  const Scene a = scene_of(unix_text), b = scene_of(windows_text);
  ASSERT_EQ(b.root.objects.size(), 2u);
  EXPECT_EQ(shape_of<Sphere>(b.root.objects[0]).radius, 0.5);
  EXPECT_EQ(a.placements, b.placements);
  EXPECT_EQ(a.triangles->vertices, b.triangles->vertices);
  EXPECT_EQ(pictures(read(windows_text)).at(0).file, "a.png");
}

TEST(Text, startsACommentAnywhere) {
  const Scene scene = scene_of("# all\n" + light +
                               "sphere 1 0 0 -4#near\n begin#\nvertex 0 0 0# a\nvertex 1 0 0 #\n"
                               "vertex 0 1 0#\nend#\n");
  EXPECT_EQ(scene.root.objects.size(), 2u);
}

TEST(Text, readsAnEmptyFile) {
  EXPECT_EQ(told(""), "s.cli: warning: there is no object in this picture\n");
  EXPECT_EQ(pictures(read("")).size(), 1u);
  EXPECT_EQ(pictures(read("\xEF\xBB\xBF")).size(), 1u);
}

TEST(Text, saysThatAFileIsUtf16) {
  EXPECT_EQ(told(std::string("\xFF\xFE"
                             "f\0o\0",
                             6)),
            "s.cli:1:1: error: this is UTF-16 text; save it as UTF-8\n");
}

TEST(NearWord, countsInsertionsRemovalsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("sphere", "sphere"), 0);
  EXPECT_EQ(edit_distance("spere", "sphere"), 1);
  EXPECT_EQ(edit_distance("sphhere", "sphere"), 1);
  EXPECT_EQ(edit_distance("sphare", "sphere"), 1);
  EXPECT_EQ(edit_distance("shpere", "sphere"), 1);
  EXPECT_EQ(edit_distance("Sphere", "sphere"), 0);
  EXPECT_EQ(edit_distance("", "fov"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearWord, findsTheNearestOrNothing) {
  EXPECT_EQ(nearest_word("translte", {"scale", "translate"}), "translate");
  EXPECT_EQ(nearest_word("banana", {"scale", "translate"}), "");
  EXPECT_EQ(nearest_word("x", {"y"}), "");
  EXPECT_EQ(nearest_word(std::string(1000, 'a'), {"scale"}), "");
  EXPECT_EQ(did_you_mean("fov"), "did you mean `fov`?");
  EXPECT_EQ(did_you_mean(""), "");
}

}  // namespace
}  // namespace penumbra
