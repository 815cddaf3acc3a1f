// Limits that keep any input, however contrived, from exhausting the machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace penumbra {

struct Limits {
  std::size_t open_files = 64;                   // open at once, each read by the one before
  std::size_t reads = 65'536;                    // files opened in total
  std::uint64_t bytes = std::uint64_t{4} << 30;  // read in total
  std::size_t copies = std::size_t{1} << 23;     // objects, lights and the like copied for pictures, in total
  std::size_t pushes = 4'096;                    // `push` still without its `pop`
  int nesting = 64;                              // levels of groups and instances
};

}  // namespace penumbra
