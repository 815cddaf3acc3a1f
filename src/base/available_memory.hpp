// How much memory the process may still take.
#pragma once

#include <cstdint>
#include <filesystem>

namespace penumbra {

// In bytes: the least of what the machine has available, without its swap, and of what the control groups of the
// process (version 1 or 2) and its limit of address space (`ulimit -v`) leave. A large number where nothing is known.
// `root` is where /proc and /sys are.
std::uint64_t available_memory(const std::filesystem::path& root = "/");

// What the process has of the machine's memory, in bytes; 0 if it is unknown.
std::uint64_t resident_memory();

}  // namespace penumbra
