// A mapped file that somebody makes shorter: zeros in place of what is missing, and an answer when asked.
#include "base/mapped_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "base/test_folder.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t size = std::size_t{1} << 20;

class Mapped : public testing::Test {
 protected:
  Mapped() {
    test::put_content(path_, std::string(size, 'x'));
    const int descriptor = ::open(path_.c_str(), O_RDONLY);
    file_ = MappedFile(descriptor, size);
    ::close(descriptor);
  }

  std::size_t count(char letter) const {
    const std::string_view view = file_.view();
    return static_cast<std::size_t>(std::count(view.begin(), view.end(), letter));
  }

  test::TestFolder folder_;
  const fs::path path_ = folder_ / "file";
  MappedFile file_;
};

TEST_F(Mapped, ShowsTheFile) {
  EXPECT_EQ(count('x'), size);
  EXPECT_FALSE(file_.has_shrunk() || file_.has_gap());
  MappedFile moved = std::move(file_);
  file_ = MappedFile();
  EXPECT_EQ(moved.view(), std::string(size, 'x'));
}

TEST_F(Mapped, HasZerosWhereItShrank) {
  fs::resize_file(path_, size / 4);
  EXPECT_TRUE(file_.has_shrunk());
  EXPECT_FALSE(file_.has_gap());
  EXPECT_EQ(file_.view()[size - 1], '\0');
  EXPECT_TRUE(file_.has_gap());
  EXPECT_EQ(count('x'), size / 4);
  EXPECT_EQ(count('\0'), size - size / 4);
}

TEST_F(Mapped, KnowsThatItsLastPageShrank) {
  fs::resize_file(path_, size - 1);
  EXPECT_TRUE(file_.has_shrunk());
}

TEST_F(Mapped, DoesNotHideOtherFaults) {
  const pid_t child = ::fork();
  if (child == 0) {
    file_ = MappedFile();
    ::raise(SIGBUS);
    ::raise(SIGBUS);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_NE(status, 0);
}

}  // namespace
}  // namespace penumbra
