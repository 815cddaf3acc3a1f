// What the program says: nothing in it commands a terminal, and it is bounded.
#include "base/say.hpp"

#include <gtest/gtest.h>

#include <string>

namespace penumbra {
namespace {

TEST(Printable, KeepsTextInUtf8) {
  for (const std::string text : {"", "plain", "a\tb", "Kugel fällt", "\u6f22\u5b57", "\U0001F600", "\u00A0\u200D"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ReplacesWhatCommandsATerminal) {
  EXPECT_EQ(printable("\x1b[31mred\x07\r\n\x7f"), "?[31mred????");
  EXPECT_EQ(printable("\u009b31m and \u0085"), "?31m and ?");  // C1
  for (const std::string mark :
       {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069"}) {
    EXPECT_EQ(printable("a" + mark + "b"), "a?b");
  }
  EXPECT_EQ(printable(std::string_view("\0", 1)), "?");
}

TEST(Printable, ReplacesWhatIsNotUtf8) {
  EXPECT_EQ(printable("\x9b\x31m"), "?1m");               // C1 in Latin-1
  EXPECT_EQ(printable("\xc0\x9b\xe0\x82\x9b"), "?????");  // ESC and C1 in longer forms than needed
  EXPECT_EQ(printable("\xed\xa0\x80"), "???");            // half of a UTF-16 pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80\xff"), "?????");  // beyond Unicode
  EXPECT_EQ(printable("ab\xe2\x80"), "ab??");             // cut short
}

std::string said(void (*tell)(std::string_view), std::string_view text) {
  testing::internal::CaptureStderr();
  tell(text);
  return testing::internal::GetCapturedStderr();
}

TEST(Say, KeepsLinesAndComplainsInOne) {
  EXPECT_EQ(said(say, "one\ntwo\x1b[2J\n"), "one\ntwo?[2J\n");
  EXPECT_EQ(said(complain, "a name\npenumbra: done"), "penumbra: a name?penumbra: done\n");
  EXPECT_EQ(said(warn, "odd"), "penumbra: warning: odd\n");
}

TEST(Say, CutsTheMiddleOfALongLine) {
  const std::string text = said(complain, "cannot read `" + std::string(100'000, 'x') + "`: it is missing");
  EXPECT_LE(text.size(), longest_line + 1);
  EXPECT_TRUE(text.starts_with("penumbra: cannot read `xxx")) << text;
  EXPECT_TRUE(text.ends_with("xxx`: it is missing\n")) << text;
  const std::string wide = said(
      say, std::string(300, 'x') + [] {
        std::string many;
        for (int i = 0; i < 1000; i++) many += "\u6f22";
        return many;
      }());
  EXPECT_EQ(printable(wide), wide) << "no character is cut";
}

}  // namespace
}  // namespace penumbra
