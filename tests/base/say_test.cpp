// What the program says: nothing in it commands a terminal, and it is bounded.
#include "base/say.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

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

TEST(StandardStreams, ThatAreClosedStayUnusableAndNoFileTakesTheirPlace) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int stream : {0, 1, 2}) ::close(stream);
    prepare_standard_streams();
    char byte = 0;
    const bool unusable = ::read(0, &byte, 1) < 0 && ::write(1, "x", 1) < 0 && ::write(2, "x", 1) < 0;
    ::_exit(unusable && ::open("/dev/zero", O_RDWR) > 2 ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

// The work does not wait for a reader that does not read: here, the pipe is full.
TEST(StandardStreams, ProgressDoesNotWaitForItsReader) {
  const pid_t child = ::fork();
  if (child == 0) {
    int ends[2];
    if (::pipe(ends) != 0) ::_exit(2);
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    while (::write(ends[1], "x", 1) == 1) continue;
    ::fcntl(ends[1], F_SETFL, 0);
    ::dup2(ends[1], STDERR_FILENO);
    ::alarm(60);
    say_progress("10 % done");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace penumbra
