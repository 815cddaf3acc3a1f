// Signal handlers may only use lock-free atomics and async-signal-safe functions.
#include "app/sessions/interruption.hpp"

#include <sysexits.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>

namespace penumbra {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
constexpr std::array names{"SIGINT", "SIGTERM", "SIGHUP"};

std::atomic<int> received{0};
std::atomic<bool> only_noted{false};
std::atomic<std::atomic<bool>*> stop_flag{nullptr};  // null: there is nothing to save yet
std::array<struct sigaction, signals.size()> old_actions;

static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int number) {
  if (received.exchange(number) != 0) {
    std::signal(number, SIG_DFL);
    std::raise(number);  // delivered when the handler returns
    return;
  }
  std::atomic<bool>* const flag = stop_flag.load();
  if (flag) {
    flag->store(true);
    return;
  }
  constexpr std::string_view words = "penumbra: interrupted before there was anything to save\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, words.data(), words.size());
  ::_exit(EX_TEMPFAIL);
}

}  // namespace

Interruption::Interruption() {
  received = 0;
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
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals.size(); i++) ::sigaction(signals[i], &old_actions[i], nullptr);
}

void Interruption::stop_through(std::atomic<bool>* flag) {
  stop_flag = flag ? flag : &only_noted;
  if (received != 0) stop_flag.load()->store(true);
}

const char* Interruption::signal() const {
  for (std::size_t i = 0; i < signals.size(); i++) {
    if (received == signals[i]) return names[i];
  }
  return nullptr;
}

}  // namespace penumbra
