// The signals that ask a render to end: SIGINT (Ctrl-C), SIGTERM (schedulers), SIGHUP (the terminal is gone).
#pragma once

#include <atomic>

namespace penumbra {

// While it lives, the first such signal is recorded, and a second one ends the program at once. Only one may exist.
class Interruption {
 public:
  // Until stop_through() is called there is nothing to save: a signal ends the program with exit code 75.
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // From now on a signal sets this flag; with null it is only recorded.
  void stop_through(std::atomic<bool>* flag);

  // The name of the signal that was received; null if none was.
  const char* signal() const;
};

}  // namespace penumbra
