// How often this process has asked for memory and for locks: call_counts.cpp stands between everybody, libraries too,
// and the C library. For executables of their own, without sanitizers.
#pragma once

#include <cstdint>

namespace penumbra::test {

struct CallCounts {
  std::uint64_t allocations = 0;  // malloc and its relatives, under operator new too
  std::uint64_t locks = 0;        // of mutexes, read-write locks and spin locks

  bool operator==(const CallCounts&) const = default;
};

// Since the process began, by all its threads.
CallCounts call_counts();

}  // namespace penumbra::test
