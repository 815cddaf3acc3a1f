// Counts how often this process asks for memory and for locks: call_counts.cpp intercepts these calls to the C library,
// from all libraries, too. For separate executables, without sanitizers.
#pragma once

#include <cstdint>

namespace penumbra::test {

struct CallCounts {
  std::uint64_t allocations = 0;  // malloc and its relatives, also in operator new
  std::uint64_t locks = 0;        // of mutexes, read-write locks and spin locks

  bool operator==(const CallCounts&) const = default;
};

// Since the process started, by all its threads.
CallCounts call_counts();

}  // namespace penumbra::test
