// Atomic writing: what is there after success, after every kind of failure, and after a run that was killed.
#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <thread>

#include "base/test_folder.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::put_content;
using test::TestFolder;
using Names = std::vector<std::string>;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

void write(const fs::path& path, const std::string& text) { write_file_atomically(path, bytes_of(text)); }

// The error of a write; exit code 0 if there is none.
FileError error_of_writing(const fs::path& path, const std::string& text) {
  try {
    write(path, text);
  } catch (const FileError& error) {
    return error;
  }
  return {0, "no error"};
}

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  ::stat(path.c_str(), &status);
  return status.st_mode & 07777;
}

std::string host() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return std::string(name).substr(0, 64);
}

// A process id that is no longer in use.
pid_t dead_pid() {
  const pid_t pid = ::fork();
  if (pid == 0) ::_exit(0);
  ::waitpid(pid, nullptr, 0);
  return pid;
}

// While this lives, files larger than `bytes` cannot be written, as on a full disk. The signal must be ignored, because
// it would kill the process.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    ::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int);
};

// Root may do everything; as nobody, the process is subject to permissions.
class AsNobody {
 public:
  AsNobody() : was_root_(::geteuid() == 0) {
    if (was_root_ && ::seteuid(65534) != 0) was_root_ = false;
  }
  ~AsNobody() {
    if (was_root_ && ::seteuid(0) != 0) std::abort();
  }

 private:
  bool was_root_;
};

TEST(AtomicFile, WritesANewFileAndReplacesAnOldOne) {
  const TestFolder folder;
  write(folder / "out", "first");
  EXPECT_EQ(content_of(folder / "out"), "first");
  write(folder / "out", "second, longer");
  EXPECT_EQ(content_of(folder / "out"), "second, longer");
  write(folder / "out", "");
  EXPECT_EQ(content_of(folder / "out"), "");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, WritesANameWithoutFolder) {
  const TestFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  write("out", "here");
  fs::current_path(before);
  EXPECT_EQ(content_of(folder / "out"), "here");
}

TEST(AtomicFile, TheOldFileIsReplacedNotOverwritten) {
  const TestFolder folder;
  put_content(folder / "out", "old");
  const int reader = ::open((folder / "out").c_str(), O_RDONLY);
  write(folder / "out", "new");
  char seen[8] = {};
  EXPECT_EQ(::read(reader, seen, sizeof seen), 3);
  EXPECT_STREQ(seen, "old");
  ::close(reader);
}

TEST(AtomicFile, KeepsThePermissionsOfAnOldFile) {
  const TestFolder folder;
  for (const mode_t mode : {0600u, 0640u, 0666u}) {
    put_content(folder / "out", "old");
    ::chmod((folder / "out").c_str(), mode);
    write(folder / "out", "new");
    EXPECT_EQ(mode_of(folder / "out"), mode);
  }
}

TEST(AtomicFile, ANewFileGetsThePermissionsOfTheUmask) {
  const TestFolder folder;
  const mode_t before = ::umask(027);
  write(folder / "out", "new");
  ::umask(before);
  EXPECT_EQ(mode_of(folder / "out"), 0640u);
}

TEST(AtomicFile, FollowsSymbolicLinks) {
  const TestFolder folder;
  fs::create_directory(folder / "deep");
  put_content(folder / "deep/real", "old");
  fs::create_symlink("deep/real", folder / "link");
  fs::create_symlink("link", folder / "link-to-link");
  write(folder / "link-to-link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "link-to-link"));
  EXPECT_EQ(content_of(folder / "deep/real"), "new");
}

TEST(AtomicFile, ALinkToNowhereMakesTheFileItNames) {
  const TestFolder folder;
  fs::create_symlink(folder / "real", folder / "link");
  write(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(folder / "real"), "new");
}

TEST(AtomicFile, ALoopOfLinksIsAnError) {
  const TestFolder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_EQ(error_of_writing(folder / "a", "x").exit_code, 73);
}

TEST(AtomicFile, NoSuchFolder) {
  const TestFolder folder;
  const fs::path path = folder / "none/out.png";
  const FileError error = error_of_writing(path, "x");
  EXPECT_EQ(error.exit_code, 73);
  EXPECT_EQ(std::string(error.what()), "cannot create `" + path.string() + "`: No such file or directory");
  EXPECT_EQ(folder.names(), Names{});
}

TEST(AtomicFile, AFolderIsNotAFile) {
  const TestFolder folder;
  EXPECT_EQ(error_of_writing(folder.path(), "x").exit_code, 73);
  EXPECT_EQ(error_of_writing("", "x").exit_code, 73);
}

TEST(AtomicFile, AFolderThatMayNotBeWrittenTo) {
  const TestFolder folder;
  put_content(folder / "out", "old");
  ::chmod((folder / "out").c_str(), 0666);
  ::chmod(folder.path().c_str(), 0555);
  FileError error(0, "");
  {
    const AsNobody nobody;
    error = error_of_writing(folder / "out", "new");
  }
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(error.exit_code, 73);
  EXPECT_NE(std::strstr(error.what(), "Permission denied"), nullptr) << error.what();
  EXPECT_EQ(content_of(folder / "out"), "old");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, AWriteProtectedFileIsNotReplaced) {
  const TestFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  put_content(folder / "out", "old");
  ::chmod((folder / "out").c_str(), 0444);
  // access() checks the real user, so only a process that is entirely nobody will do.
  int status = 0;
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(1);
    ::_exit(error_of_writing(folder / "out", "new").exit_code);
  }
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 73);
  EXPECT_EQ(content_of(folder / "out"), "old");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, AFullDiskLeavesTheOldFileAndNoTemporary) {
  const TestFolder folder;
  put_content(folder / "out", "old");
  FileError error(0, "");
  {
    const FileSizeLimit limit(1000);
    error = error_of_writing(folder / "out", std::string(5000, 'x'));
  }
  EXPECT_EQ(error.exit_code, 74);
  EXPECT_NE(std::strstr(error.what(), "cannot write `"), nullptr) << error.what();
  EXPECT_EQ(content_of(folder / "out"), "old");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, ADeviceIsWrittenDirectly) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const FileError error = error_of_writing("/dev/full", "x");
  EXPECT_EQ(error.exit_code, 74);
  EXPECT_STREQ(error.what(), "cannot write `/dev/full`: No space left on device");
  EXPECT_EQ(error_of_writing("/dev/null", "x").exit_code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, APipeIsWrittenDirectly) {
  const TestFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content_of(pipe); });
  write(pipe, "through the pipe");
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(AtomicFile, StandardOutputIsContinued) {
  const TestFolder folder;
  put_content(folder / "log", "before ");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open((folder / "log").c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
    ::_exit(error_of_writing("/dev/stdout", "after").exit_code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content_of(folder / "log"), "before after");
}

TEST(AtomicFile, TheNextWriteRemovesWhatADeadRunLeft) {
  const TestFolder folder;
  const std::string dead = ".out." + std::to_string(dead_pid()) + "@" + host() + ".0.tmp";
  put_content(folder / dead, "half");
  write(folder / "out", "whole");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, AFailedWriteRemovesItToo) {
  const TestFolder folder;
  put_content(folder / (".out." + std::to_string(dead_pid()) + "@" + host() + ".0.tmp"), "half");
  const FileSizeLimit limit(100);
  EXPECT_EQ(error_of_writing(folder / "out", std::string(200, 'x')).exit_code, 74);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(AtomicFile, OtherFilesAreLeftAlone) {
  const TestFolder folder;
  const std::string dead = std::to_string(dead_pid());
  const Names others{".out." + std::to_string(::getppid()) + "@" + host() + ".0.tmp",  // its run is alive
                     ".out." + dead + "@another-host.0.tmp",
                     ".out.extra." + dead + "@" + host() + ".0.tmp",  // belongs to out.extra
                     ".out." + dead + "@" + host() + ".0.txt",
                     ".out.tmp",
                     "out.tmp"};
  for (const std::string& name : others) put_content(folder / name, "mine");
  write(folder / "out", "whole");
  Names expected = others;
  expected.push_back("out");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(folder.names(), expected);
}

TEST(AtomicFile, AKilledRunLeavesTheOldFile) {
  const TestFolder folder;
  put_content(folder / "out", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    // The signal for an oversized file kills in the middle of the write.
    const rlimit limit{4096, 4096}, no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_DFL);
    write(folder / "out", std::string(100000, 'x'));
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(content_of(folder / "out"), "old");
  ASSERT_EQ(folder.names().size(), 2u);
  write(folder / "out", "new");
  EXPECT_EQ(content_of(folder / "out"), "new");
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, SeveralWritersAtOnceLeaveOneWholeFile) {
  const TestFolder folder;
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'e'; letter++) {
    writers.emplace_back([&folder, letter] {
      for (int i = 0; i < 20; i++) write(folder / "out", std::string(20000, letter));
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string content = content_of(folder / "out");
  EXPECT_EQ(content, std::string(20000, content.at(0)));
  EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, TheLongestPossibleNameIsFine) {
  const TestFolder folder;
  const std::string name(255, 'n');
  write(folder / name, "x");
  EXPECT_EQ(folder.names(), Names{name});
}

TEST(ReadFile, GivesWhatIsThere) {
  const TestFolder folder;
  for (const std::size_t size : {0u, 1u, 65536u, 200000u}) {
    const std::string content(size, 'r');
    put_content(folder / "in", content);
    const std::vector<std::byte> bytes = read_file(folder / "in");
    ASSERT_EQ(bytes.size(), size);
    EXPECT_TRUE(size == 0 || std::memcmp(bytes.data(), content.data(), size) == 0);
  }
  EXPECT_FALSE(read_file("/proc/self/status").empty());  // a file with a stated size of 0
}

TEST(ReadFile, TellsWhatIsWrong) {
  const TestFolder folder;
  const auto code_of_reading = [](const fs::path& path) {
    try {
      read_file(path);
    } catch (const FileError& error) {
      return error.exit_code;
    }
    return 0;
  };
  EXPECT_EQ(code_of_reading(folder / "none"), 66);
  EXPECT_EQ(code_of_reading(folder.path()), 66);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(code_of_reading(folder / "pipe"), 66);  // without waiting for a writer
  EXPECT_EQ(code_of_reading("/dev/zero"), 66);
  put_content(folder / "sparse", "");
  fs::resize_file(folder / "sparse", std::uintmax_t{1} << 42);
  EXPECT_EQ(code_of_reading(folder / "sparse"), 65);
}

TEST(ReadFile, StopsAtAFileThatIsNotWanted) {
  const TestFolder folder;
  put_content(folder / "in", std::string(100'000, 'x'));
  const auto begins_with_x = [](std::span<const std::byte> bytes) { return bytes.front() == std::byte{'x'}; };
  EXPECT_EQ(read_file(folder / "in", begins_with_x).size(), 100'000u);
  EXPECT_EQ(read_file(folder / "in", [](auto) { return false; }).size(), 4096u);
}

}  // namespace
}  // namespace penumbra
