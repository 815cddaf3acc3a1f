// A scene names files only beside it, unless it may name any.
#include "language/path_boundary.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/test_folder.hpp"
#include "language/scene_file.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

const std::string secret = "root:secret";

class Path : public testing::Test {
 protected:
  Path() : before_(fs::current_path()) {
    for (const char* folder : {"scene", "scene/parts", "work", "other"}) fs::create_directories(folder_ / folder);
    fs::current_path(folder_ / "work");
    test::put_content(folder_ / "other/file.cli", secret + "\n");
    test::put_content(folder_ / "work/file.cli", secret + "\n");
    test::put_content(folder_ / "scene/parts/ball.cli", "sphere 1 0 0 -4\n");
    test::put_content(folder_ / "scene/parts/again.cli", "read ../parts/ball.cli\nread ball.cli\n");
  }
  ~Path() override { fs::current_path(before_); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

  // All that is said of a scene with this line.
  std::string told(const std::string& line, bool allow_paths = false, const std::string& scene = "scene/s.cli") const {
    const fs::path path = folder_ / scene;
    test::put_content(path, "light 0 9 0 1 1 1\nsphere 1 0 0 -4\n" + line + "\n");
    std::string said;
    for (const Diagnostic& d : read_scene(path, {.allow_paths = allow_paths}).diagnostics) said += to_string(d);
    return said;
  }

  test::TestFolder folder_;
  fs::path before_;
};

TEST_F(Path, IsReadBesideTheScene) {
  const std::string folder = fs::canonical(folder_.path()).string();
  EXPECT_EQ(told("read parts/ball.cli"), "");
  EXPECT_EQ(told("read parts/again.cli"), "");
  EXPECT_EQ(told("read ../scene/parts/ball.cli"), "");
  EXPECT_EQ(told("read " + folder + "/scene/parts/ball.cli"), "");
  fs::create_symlink("scene", folder_ / "link");
  EXPECT_EQ(told("read parts/ball.cli", false, "link/s.cli"), "");
  fs::create_symlink("parts/ball.cli", folder_ / "scene/linked.cli");
  EXPECT_EQ(told("read linked.cli"), "");
}

TEST_F(Path, IsNotReadElsewhere) {
  fs::create_symlink("../other/file.cli", folder_ / "scene/linked.cli");
  fs::create_symlink("../other", folder_ / "scene/folder");
  fs::create_symlink("../other/none.cli", folder_ / "scene/dangling.cli");
  const std::string folder = folder_.path().string();
  for (const std::string name :
       {"../other/file.cli", "parts/../../other/file.cli", "linked.cli", "folder/file.cli", "dangling.cli",
        "../work/file.cli", "../none.cli", "/etc/shadow", "/etc/passwd", "/", "/proc/self/environ"}) {
    for (const std::string command : {"read ", "mesh "}) {
      const std::string said = told(command + name);
      EXPECT_NE(said.find(": it is outside the folder of the scene; --allow-paths allows that\n"), said.npos)
          << command << name << said;
      EXPECT_EQ(said.find("root"), said.npos) << said;
      EXPECT_EQ(said.find("did you mean"), said.npos) << said;
    }
  }
  test::put_content(folder_ / "scene/parts/out.cli", "read ../../other/file.cli\n");
  EXPECT_NE(told("read parts/out.cli").find("it is outside"), std::string::npos);
  EXPECT_NE(told("read ../other/file.cli", true).find("unknown command"), std::string::npos);
}

TEST_F(Path, IsWrittenInTheWorkingFolderOrBesideTheScene) {
  const std::string folder = folder_.path().string();
  fs::create_symlink("../other/new.png", folder_ / "work/dangling.png");
  fs::create_symlink("../other", folder_ / "work/folder");
  for (const std::string name : {"out.png", "sub/out.png", "../work/out.png", "../scene/out.png"}) {
    EXPECT_EQ(told("write " + name), "") << name;
  }
  EXPECT_EQ(told("write " + folder + "/scene/out.png"), "");
  for (const std::string name :
       {"../out.png", "../other/out.png", "/tmp/out.png", "dangling.png", "folder/out.png", "/dev/stdout.png"}) {
    EXPECT_NE(told("write " + name).find(":3:7: error: cannot write `" + name + "`: it is outside the working folder"),
              std::string::npos)
        << told("write " + name);
    EXPECT_EQ(told("write " + name, true), "") << name;
  }
}

// A file that others may not read, under a name that is not a scene's.
TEST_F(Path, OfASecretShowsNothingOfIt) {
  for (const char* name : {"scene/shadow", "scene/mine.cli"}) {
    test::put_content(folder_ / name, secret + "\nsphere " + secret + "\nnamed_object root\n");
    fs::permissions(folder_ / name, fs::perms::owner_read | fs::perms::owner_write);
  }
  const auto check = [&](const fs::path& path) {
    std::string said;
    for (const Diagnostic& d : read_scene(path, {}).diagnostics) said += to_string(d);
    return said;
  };
  const std::string hidden =
      ": error: this is no scene without errors; not everybody may read it, so its lines are not shown\n";
  EXPECT_EQ(check(folder_ / "scene/shadow"), (folder_ / "scene/shadow").string() + hidden);
  EXPECT_EQ(told("read shadow"), (folder_ / "scene/shadow").string() + hidden);
  EXPECT_EQ(told("mesh shadow").find("root"), std::string::npos);
  EXPECT_NE(check(folder_ / "scene/mine.cli").find(secret), std::string::npos) << "one's own scenes are no secret";
}

TEST_F(Path, OfALoopOfLinksIsNowhere) {
  fs::create_symlink("b", folder_ / "work/a");
  fs::create_symlink("a", folder_ / "work/b");
  EXPECT_FALSE(is_in_reach("a", "s.cli"));
  EXPECT_FALSE(is_in_reach("a/x.png", "s.cli"));
  EXPECT_TRUE(is_in_reach("x.png", "s.cli"));
}

}  // namespace
}  // namespace penumbra
