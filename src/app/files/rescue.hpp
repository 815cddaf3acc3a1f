// A place for a file whose own place fails when the work is done.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace penumbra {

// Writes the bytes of a file that cannot be written as NAME.rescued.ext beside it or, where that fails too, in the
// working folder or in that for temporary files. No existing file is replaced. Returns the file; none if it cannot be
// written anywhere.
std::optional<std::filesystem::path> rescue(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace penumbra
