// Writing a whole text or file to a descriptor.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace penumbra {

// Writes everything; waits where the reader is slower. Returns the error number, 0 for none.
int write_all(int descriptor, std::span<const std::byte> bytes);
inline int write_all(int descriptor, std::string_view text) {
  return write_all(descriptor, std::as_bytes(std::span(text)));
}

}  // namespace penumbra
