// Writing to a pipe that nobody reads: an error instead of the end of the process.
#pragma once

#include <signal.h>

namespace penumbra {

// While it lives, writing to a program that has ended is an error instead of a signal.
class NoBrokenPipe {
 public:
  NoBrokenPipe() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &old_);
  }
  ~NoBrokenPipe() { ::sigaction(SIGPIPE, &old_, nullptr); }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

 private:
  struct sigaction old_ {};
};

}  // namespace penumbra
