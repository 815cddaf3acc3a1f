// What asks a render to end: the signals SIGINT (Ctrl-C), SIGTERM (schedulers) and SIGHUP (the terminal is gone), and
// the end of its time, which comes as SIGALRM.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

namespace penumbra {

// While it lives, the first such signal is recorded, and a second one from outside ends the program at once. Only one
// may exist.
class Interruption {
 public:
  // Until stop_through() is called there is nothing to lose: a signal ends the program with exit code 75, and so does
  // the end of the time, a second later.
  explicit Interruption(std::optional<std::chrono::steady_clock::time_point> end);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // From now on a signal sets this flag; one that came before sets it now.
  void stop_through(std::atomic<bool>& flag);
  // From now on a signal is only recorded.
  void only_note();
  // From now on there is nothing to lose again; one that came before ends the program in a second.
  void end_soon();

  // The name of the signal that was received from outside; null if none was.
  const char* signal() const;
};

}  // namespace penumbra
