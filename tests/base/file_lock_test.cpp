// The lock of a file: one holder at a time, whatever the file's name, and free when its holder is dead.
#include "base/file_lock.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <optional>

#include "base/atomic_file.hpp"
#include "base/test_folder.hpp"

namespace penumbra {
namespace {

using Names = std::vector<std::string>;

std::string error_of_locking(const std::filesystem::path& path) {
  try {
    const FileLock lock(path, "it is held");
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST(FileLock, HasOneHolderAtATime) {
  const test::TestFolder folder;
  {
    const FileLock lock(folder / "a", "it is held");
    EXPECT_EQ(error_of_locking(folder / "a"), "it is held");
    std::filesystem::create_symlink("a", folder / "link");
    EXPECT_EQ(error_of_locking(folder / "link"), "it is held");
    EXPECT_EQ(error_of_locking(folder / "b"), "");
  }
  EXPECT_EQ(error_of_locking(folder / "a"), "");
  EXPECT_EQ(folder.names(), Names{"link"});
}

TEST(FileLock, DiesWithItsProcess) {
  const test::TestFolder folder;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const FileLock lock(folder / "a", "it is held");
    [[maybe_unused]] const auto written = ::write(ready[1], "!", 1);
    for (;;) ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(error_of_locking(folder / "a"), "it is held");
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(error_of_locking(folder / "a"), "");
  EXPECT_EQ(folder.names(), Names{});
}

TEST(FileLock, NeedsAPlaceForItsFile) {
  const test::TestFolder folder;
  EXPECT_NE(error_of_locking(folder / "none/a").find("cannot create `"), std::string::npos);
}

}  // namespace
}  // namespace penumbra
