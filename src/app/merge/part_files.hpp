// Reads the parts of a picture from their files, and writes the picture that they make up.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "rendering/shard_part.hpp"

namespace penumbra {

struct PartFiles {
  struct Failure {
    std::string name;
    FileError error;
  };

  std::vector<std::vector<std::byte>> bytes;  // the parts point into them
  std::vector<Part> parts;                    // the intact ones
  std::vector<Failure> failures;              // the others
};

PartFiles read_parts(const std::vector<std::string>& names);

// Merges parts without problems_of() and writes their picture. Throws FileError.
void write_merged(const std::vector<Part>& parts, const std::vector<std::string>& outputs, bool quiet);

}  // namespace penumbra
