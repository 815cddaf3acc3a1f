#include "farm/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include "base/child_signals.hpp"

namespace penumbra {
namespace {

using Clock = std::chrono::steady_clock;

// A pipe that a child writes to and we read from.
struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  ~Pipe() {
    close_out();
    ::close(ends[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int in() const { return ends[0]; }
  int out() const { return ends[1]; }
  void close_out() {
    if (out() >= 0) ::close(std::exchange(ends[1], -1));
  }

  std::array<int, 2> ends{-1, -1};
};

// Returns -1 if the program cannot be started.
pid_t start(const std::vector<std::string>& words, posix_spawn_file_actions_t* actions) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t pid = -1;
  return ::posix_spawnp(&pid, argv.front(), actions, ChildSignals().get(), argv.data(), environ) == 0 ? pid : -1;
}

int wait_for(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// Reads until both are closed; false if the time runs out first.
bool read_all(const Pipe& output, const Pipe& errors, ChildResult& result, Clock::time_point end) {
  std::array<pollfd, 2> polled{pollfd{output.in(), POLLIN, 0}, pollfd{errors.in(), POLLIN, 0}};
  const std::array<std::string*, 2> texts{&result.output, &result.errors};
  while (polled[0].fd >= 0 || polled[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0) return false;
    if (::poll(polled.data(), polled.size(), static_cast<int>(left)) < 0 && errno != EINTR) return false;
    for (std::size_t i = 0; i < polled.size(); i++) {
      if (polled[i].fd < 0 || polled[i].revents == 0) continue;
      std::array<char, 65536> buffer{};
      const ssize_t count = ::read(polled[i].fd, buffer.data(), buffer.size());
      if (count > 0) texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) polled[i].fd = -1;
    }
  }
  return true;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& words, double time_limit) {
  Pipe output, errors;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output.out(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, errors.out(), STDERR_FILENO);
  const pid_t pid = start(words, &actions);
  ::posix_spawn_file_actions_destroy(&actions);
  ChildResult result;
  if (pid < 0) {
    result.errors = "no such program";
    return result;
  }
  output.close_out();
  errors.close_out();
  const auto duration = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_limit));
  if (!read_all(output, errors, result, Clock::now() + duration)) {
    ::kill(pid, SIGKILL);
    result.errors += "timed out";
  }
  result.exit_code = wait_for(pid);
  return result;
}

int run_child_in_sight(const std::vector<std::string>& words) {
  const pid_t pid = start(words, nullptr);
  return pid < 0 ? 127 : wait_for(pid);
}

}  // namespace penumbra
