// Messages that cannot be delivered do not end the work, and results that cannot be delivered are not lost in silence.
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

const std::string two_pictures =
    "image_size 8 6\nlight 2 5 1 1 1 1\nsphere 1 0 0 -4\nwrite a.png\nprint_timer\nwrite b.png\n";

class Message : public SittingTest {
 protected:
  Message() { put_content(scene_, two_pictures); }

  // Runs a command of bash in the folder; $P is the program. Returns its exit code.
  int bash(const std::string& command) {
    put_content(path("script"), "P='" PENUMBRA_PROGRAM "'\n" + command + "\n");
    result_ = run_program("cd '" + folder_.path().string() + "' && bash script");
    return result_.exit_code;
  }
  void expect_pictures(const std::string& when) const {
    for (const char* name : {"a.png", "b.png"}) {
      EXPECT_EQ(content_of(path(name)).substr(1, 3), "PNG") << when;
      std::filesystem::remove(path(name));
    }
  }

  ProgramResult result_;
};

TEST_F(Message, ThatNobodyReadsDoesNotEndTheWork) {
  put_content(path("wrong.cli"), "spere 1\n");
  for (const std::string where : {"2> /dev/full", "2>&-", "2> >(exit)", "2> /dev/full >&-", "0<&- 2>&-"}) {
    for (const std::string style : {"", "--progress json", "--progress bar", "--rays 20000 --progress json"}) {
      const int code = bash("$P render scene.cli " + style + " " + where);
      EXPECT_EQ(code, where.find(" >&-") == where.npos ? 0 : 74) << where << style;  // the timer's line is lost
      expect_pictures(where + style);
    }
    EXPECT_EQ(bash("$P render missing.cli " + where), 66);
    EXPECT_EQ(bash("$P check wrong.cli " + where), 65);
    EXPECT_EQ(bash("$P --wrong " + where), 64);
  }
}

// The reader of the progress goes away while the render goes on: it is told to by the first line.
TEST_F(Message, WhoseReaderEndsDoesNotEndTheWork) {
  const int code = bash(
      "{ $P render scene.cli --rays 300000 --progress json 2>&1 >/dev/null; echo $? > code; } | head -1; exit $(cat "
      "code)");
  EXPECT_EQ(code, 0) << result_.output;
  expect_pictures(result_.output);
}

TEST_F(Message, OfAWholeDiskIsNoSignal) {
  put_content(scene_, "image_size 200 200\nsampler random\nlight 2 5 1 1 1 1\nsphere 1 0 0 -4\n");
  put_content(picture_, "old");
  EXPECT_EQ(bash("ulimit -f 1; $P render scene.cli -o picture.exr"), 74) << result_.output;
  EXPECT_EQ(content_of(picture_), "old");
}

TEST_F(Message, ResultThatIsNotDeliveredIsAnError) {
  ASSERT_EQ(bash("$P render scene.cli --quiet > timer"), 0) << result_.output;
  EXPECT_TRUE(content_of(path("timer")).starts_with("seconds: "));
  for (const std::string where : {"> /dev/full", ">&-", "> >(exit); wait $!"}) {
    for (const std::string command : {"--help", "--version", "render --help", "check scene.cli", "compare a.png b.png",
                                      "compare --json a.png b.png", "samples -n 4", "samples -n 4 --json",
                                      "render scene.cli --debug-pixel 4,3,0"}) {
      const int code = bash("exec " + where + "; $P " + command);
      EXPECT_EQ(code, 74) << command << where;
      EXPECT_NE(result_.output.find("cannot write to standard output"), std::string::npos) << command << where;
    }
    EXPECT_EQ(bash("exec " + where + "; $P render scene.cli"), 74);
    expect_pictures(where);
    ASSERT_EQ(bash("$P render scene.cli --quiet"), 0);
    EXPECT_EQ(bash("exec " + where + "; $P check missing.cli"), 66) << "an error of the input comes first";
  }
}

TEST_F(Message, NeverCommandsATerminal) {
  const std::string bad =
      "\x1b[31m\xc2\x9b"
      "31m\xe2\x80\xae\x9b\x07";
  put_content(path("bad" + bad + ".cli"), "sphere 1 0 0 -4" + bad + "\n" + bad + " 1 2\nread x" + bad +
                                              ".cli\nnamed_object n" + bad + "\n# " + bad + "\n");
  put_content(path("good" + bad + ".cli"), "light 0 9 0 1 1 1\nsphere 1 0 0 -4\nnamed_object n" + bad + "\ninstance n" +
                                               bad + "\nsphere 1 1 0 -4\nnamed_object m" + bad + "\n");
  const std::string quoted = "$'\\x1b[31m\\xc2\\x9b31m\\xe2\\x80\\xae\\x9b\\x07'";
  for (const std::string& command :
       {"check bad" + quoted + ".cli", "check good" + quoted + ".cli", "render bad" + quoted + ".cli",
        "render good" + quoted + ".cli -o out" + quoted + ".png", "render missing" + quoted + ".cli",
        "--wrong" + quoted, "wrong" + quoted, "render good" + quoted + ".cli --rays " + quoted,
        "compare out" + quoted + ".png out" + quoted + ".png", "compare --json out" + quoted + ".png missing" + quoted,
        "merge part" + quoted + " -o a.png", "farm status job" + quoted}) {
    bash("$P " + command);
    EXPECT_FALSE(result_.output.empty()) << command;
    for (const char* raw : {"\x1b", "\xc2\x9b", "\xe2\x80\xae", "\x07"}) {
      EXPECT_EQ(result_.output.find(raw), std::string::npos) << command << '\n' << result_.output;
    }
    EXPECT_EQ(result_.output.find('\x9b'), std::string::npos) << command;
  }
}

TEST_F(Message, IsBounded) {
  std::string scene;
  for (int i = 0; i < 100; i++) scene += "read " + std::string(20'000, 'x') + "\n" + std::string(20'000, 'y') + "\n";
  put_content(scene_, scene);
  EXPECT_EQ(bash("$P check scene.cli"), 65);
  EXPECT_LT(result_.output.size(), 100'000u);
  EXPECT_EQ(bash("$P render " + std::string(100'000, 'z') + ".cli"), 66);
  EXPECT_LT(result_.output.size(), 2'000u);
  EXPECT_EQ(bash("$P render scene.cli --rays " + std::string(100'000, 'z')), 64);
  EXPECT_LT(result_.output.size(), 2'000u);
}

}  // namespace
}  // namespace penumbra::test
