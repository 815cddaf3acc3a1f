#include "language/diagnostic_list.hpp"

#include "support.hpp"

namespace penumbra {
namespace {

TEST(Diagnostics, showThePlaceTheLineTheCaretAndTheHint) {
  const Diagnostic d{Severity::error,         "a.cli", 3, 2, 5, "unknown command `spere`", " spere 1",
                     "did you mean `sphere`?"};
  EXPECT_EQ(to_string(d),
            "a.cli:3:2: error: unknown command `spere`\n"
            "   spere 1\n"
            "   ^~~~~\n"
            "  did you mean `sphere`?\n");
}

TEST(Diagnostics, leaveOutWhatThereIsNot) {
  EXPECT_EQ(to_string({Severity::warning, "a.cli", 0, 0, 1, "no light", "", ""}), "a.cli: warning: no light\n");
  EXPECT_EQ(to_string({Severity::error, "", 0, 0, 1, "too many errors", "", ""}), "error: too many errors\n");
}

TEST(Diagnostics, putTheCaretUnderTabsAndLettersOfSeveralBytes) {
  EXPECT_EQ(to_string({Severity::error, "a", 1, 7, 2, "m", "\tü x\ty1", ""}),
            "a:1:7: error: m\n  \tü x\ty1\n  \t   \t^~\n");
}

TEST(Diagnostics, doNotPassOnControlCharacters) {
  EXPECT_EQ(to_string({Severity::error, "a", 1, 1, 9, "m", "\x1b[31mred", ""}),
            "a:1:1: error: m\n  ?[31mred\n  ^~~~~~~~\n");
}

TEST(Diagnostics, leaveOutACaretBehindAShortenedLine) {
  EXPECT_EQ(to_string({Severity::error, "a", 1, 500, 9, "m", "short", ""}), "a:1:500: error: m\n  short\n");
}

TEST(Diagnostics, tellErrorsFromWarnings) {
  EXPECT_FALSE(has_error({}));
  EXPECT_FALSE(has_error({{Severity::warning, "", 0, 0, 1, "", "", ""}}));
  EXPECT_TRUE(has_error({{Severity::warning, "", 0, 0, 1, "", "", ""}, {Severity::error, "", 0, 0, 1, "", "", ""}}));
}

TEST(Diagnostics, shortenVeryLongLinesAndWords) {
  const SceneFile file = read(std::string(1'000'000, 'x') + "\n" + ball);
  ASSERT_EQ(file.diagnostics.size(), 1u);
  EXPECT_LE(file.diagnostics[0].source_line.size(), 400u);
  EXPECT_EQ(file.diagnostics[0].message, "unknown command `" + std::string(40, 'x') + "...`");
  EXPECT_LE(to_string(file.diagnostics[0]).size(), 1000u);
}

TEST(Diagnostics, areInTheOrderOfTheFile) {
  // An error that is known only at the end (the open `begin_list`) is sorted to its line.
  EXPECT_EQ(told("begin_list\nfoo\n" + ball + "bar\n"),
            "s.cli:1:1: error: this group is left open: there is no `end_list` or `end_accel` for it\n"
            "  begin_list\n  ^~~~~~~~~~\n"
            "s.cli:2:1: error: unknown command `foo`\n  foo\n  ^~~\n  did you mean `fov`?\n"
            "s.cli:4:1: error: unknown command `bar`\n  bar\n  ^~~\n");
}

TEST(Diagnostics, placeThoseOfAReadFileAtItsLine) {
  EXPECT_EQ(told("zzz1\nread b.cli\nzzz4\n", {}, {{"b.cli", "zzz2\nzzz3\n"}}),
            "s.cli:1:1: error: unknown command `zzz1`\n  zzz1\n  ^~~~\n"
            "b.cli:1:1: error: unknown command `zzz2`\n  zzz2\n  ^~~~\n"
            "b.cli:2:1: error: unknown command `zzz3`\n  zzz3\n  ^~~~\n"
            "s.cli:3:1: error: unknown command `zzz4`\n  zzz4\n  ^~~~\n");
}

TEST(Diagnostics, areToldOnceForAFileReadTwice) {
  EXPECT_EQ(told("read b.cli\nread b.cli\n", {}, {{"b.cli", "zzz\n"}}),
            "b.cli:1:1: error: unknown command `zzz`\n  zzz\n  ^~~\n");
}

TEST(Diagnostics, stopAfterTwentyErrors) {
  std::string text;
  for (int i = 0; i < 20; i++) text += "zzz" + std::to_string(i) + "\n";
  EXPECT_EQ(read(text).diagnostics.size(), 20u);
  SceneFile file = read(text + "zzz20\nzzz21\nzzz22\n");
  ASSERT_EQ(file.diagnostics.size(), 21u);
  EXPECT_EQ(to_string(file.diagnostics[19]), "s.cli:20:1: error: unknown command `zzz19`\n  zzz19\n  ^~~~~\n");
  EXPECT_EQ(to_string(file.diagnostics[20]), "error: too many errors; the rest is not read\n");
  EXPECT_TRUE(file.actions.empty());
}

TEST(Diagnostics, leaveOutWarningsBeyondFifty) {
  std::string text = light + ball;
  for (int i = 0; i < 60; i++) text += "push\n";
  const SceneFile file = read(text);
  ASSERT_EQ(file.diagnostics.size(), 51u);
  EXPECT_EQ(to_string(file.diagnostics[50]), "warning: 10 more warnings are left out\n");
  EXPECT_EQ(file.actions.size(), 1u);
}

}  // namespace
}  // namespace penumbra
