// Signal handlers may only use lock-free atomics and async-signal-safe functions.
#include "app/sessions/interruption.hpp"

#include <sys/time.h>
#include <sysexits.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <string_view>

namespace penumbra {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGALRM};
constexpr std::array names{"SIGINT", "SIGTERM", "SIGHUP"};

std::atomic<int> received{0};  // from outside
std::atomic<bool> time_is_up{false};
std::atomic<bool> noted{false};
std::atomic<std::atomic<bool>*> stop_flag{nullptr};  // null: there is nothing to lose
std::array<struct sigaction, signals.size()> old_actions;

static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

[[noreturn]] void end() {
  const std::string_view words = time_is_up
                                     ? "penumbra: the time limit is reached before the first ray of the picture\n"
                                     : "penumbra: interrupted before the first ray of the picture\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words.data(), words.size());
  ::_exit(EX_TEMPFAIL);
}

// How long the preparation of a scene may go on when the time is up.
constexpr unsigned seconds_of_grace = 1;

void handle(int number) {
  if (number == SIGALRM) {
    const bool again = time_is_up.exchange(true) || received != 0;
    if (!again && !stop_flag.load()) {
      ::alarm(seconds_of_grace);
      return;
    }
  } else if (received.exchange(number) != 0) {
    std::signal(number, SIG_DFL);
    std::raise(number);  // delivered when the handler returns
    return;
  }
  std::atomic<bool>* const flag = stop_flag.load();
  if (!flag) end();
  flag->store(true);
}

// Delivers SIGALRM after so many seconds, at least one microsecond; 0 disarms.
void set_alarm(double seconds) {
  constexpr double longest = 1e9;
  itimerval timer{};
  if (seconds != 0) {
    seconds = std::clamp(seconds, 1e-6, longest);
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  }
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

Interruption::Interruption(std::optional<std::chrono::steady_clock::time_point> end) {
  received = 0;
  time_is_up = false;
  stop_flag = nullptr;
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); i++) {
    ::sigaction(signals[i], nullptr, &old_actions[i]);
    // `nohup` asks to keep running when the terminal is gone.
    const bool is_unwanted = signals[i] == SIGHUP && old_actions[i].sa_handler == SIG_IGN;
    if (!is_unwanted) ::sigaction(signals[i], &action, nullptr);
  }
  if (end) {
    const std::chrono::duration<double> left = *end - std::chrono::steady_clock::now();
    set_alarm(std::max(left.count(), 1e-6));
  }
}

Interruption::~Interruption() {
  set_alarm(0);
  for (std::size_t i = 0; i < signals.size(); i++) ::sigaction(signals[i], &old_actions[i], nullptr);
}

void Interruption::stop_through(std::atomic<bool>& flag) {
  stop_flag = &flag;
  if (received != 0 || time_is_up) flag = true;
}

void Interruption::only_note() { stop_flag = &noted; }

void Interruption::end_soon() {
  stop_flag = nullptr;
  if (received != 0 || time_is_up) ::alarm(seconds_of_grace);
}

const char* Interruption::signal() const {
  for (std::size_t i = 0; i < names.size(); i++) {
    if (received == signals[i]) return names[i];
  }
  return nullptr;
}

}  // namespace penumbra
