// Bounds that keep any input, however made, from exhausting the machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace penumbra {

struct Limits {
  std::size_t open_files = 64;                   // files that read one another
  std::size_t reads = 65'536;                    // files opened altogether
  std::uint64_t bytes = std::uint64_t{4} << 30;  // read altogether
  std::size_t copies = std::size_t{1} << 23;     // objects, lights and the like copied for pictures, altogether
  std::size_t pushes = 4'096;                    // `push` without `pop` so far
  int nesting = 64;                              // groups and instances in one another
};

}  // namespace penumbra
