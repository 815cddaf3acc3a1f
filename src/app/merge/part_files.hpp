// The parts of a picture, read from their files, and the picture that they are together.
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

  std::vector<std::vector<std::byte>> bytes;  // which the parts point into
  std::vector<Part> parts;                    // those that are whole
  std::vector<Failure> failures;              // the others
};

PartFiles read_parts(const std::vector<std::string>& names);

// Writes the picture of parts about which there is no problem. Throws FileError.
void write_merged(const std::vector<Part>& parts, const std::vector<std::string>& outputs, bool quiet);

}  // namespace penumbra
