#include "base/mapped_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>

namespace penumbra {
namespace {

constexpr std::size_t release_step = std::size_t{16} << 20;

// A mapping that is in use, for the signal handler.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<std::uintptr_t> begin{0}, end{0};
  std::atomic<bool> gap{false};
};

std::array<Slot, 256> slots;
struct sigaction old_action;
static_assert(std::atomic<std::uintptr_t>::is_always_lock_free);

// Puts zeros from the page of this address to the end of the mapping; false if it is not in one of ours.
bool fill_gap(std::uintptr_t address) {
  static const auto page = static_cast<std::uintptr_t>(::getpagesize());
  for (Slot& slot : slots) {
    const std::uintptr_t end = slot.end;
    if (address < slot.begin || address >= end) continue;
    const std::uintptr_t first = address / page * page;
    slot.gap = true;
    return ::mmap(reinterpret_cast<void*>(first), end - first, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1,
                  0) != MAP_FAILED;
  }
  return false;
}

void handle(int number, siginfo_t* info, void*) {
  const int error = errno;
  // Any other fault repeats when the handler returns, and is then treated as before.
  if (!fill_gap(reinterpret_cast<std::uintptr_t>(info->si_addr))) ::sigaction(number, &old_action, nullptr);
  errno = error;
}

void handle_faults() {
  static const bool done = [] {
    struct sigaction action {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO;
    ::sigemptyset(&action.sa_mask);
    return ::sigaction(SIGBUS, &action, &old_action) == 0;
  }();
  static_cast<void>(done);
}

// The number of a free slot, which is then taken; slots.size() if there is none.
std::size_t take_slot() {
  for (std::size_t i = 0; i < slots.size(); i++) {
    if (!slots[i].taken.exchange(true)) return i;
  }
  return slots.size();
}

}  // namespace

MappedFile::MappedFile(int descriptor, std::size_t size) {
  const std::size_t slot = take_slot();
  if (slot == slots.size()) return;
  const int own = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  void* const address = own < 0 ? MAP_FAILED : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, own, 0);
  if (address == MAP_FAILED) {
    if (own >= 0) ::close(own);
    slots[slot].taken = false;
    return;
  }
  handle_faults();
  ::madvise(address, size, MADV_SEQUENTIAL);
  address_ = static_cast<char*>(address);
  size_ = size;
  descriptor_ = own;
  slot_ = slot;
  slots[slot].gap = false;
  slots[slot].begin = reinterpret_cast<std::uintptr_t>(address);
  slots[slot].end = slots[slot].begin + size;
}

MappedFile::~MappedFile() {
  if (address_ == nullptr) return;
  slots[slot_].end = slots[slot_].begin = 0;
  slots[slot_].taken = false;
  ::munmap(address_, size_);
  ::close(descriptor_);
}

bool MappedFile::has_gap() const { return address_ != nullptr && slots[slot_].gap.load(std::memory_order_relaxed); }

bool MappedFile::has_shrunk() const {
  struct stat status {};
  return has_gap() || (address_ != nullptr && ::fstat(descriptor_, &status) == 0 &&
                       static_cast<std::size_t>(status.st_size) < size_);
}

void MappedFile::release_before(std::size_t offset) {
  if (address_ == nullptr || offset < released_ + release_step) return;
  const std::size_t bytes = (offset - released_) / release_step * release_step;
  ::madvise(address_ + released_, bytes, MADV_DONTNEED);
  released_ += bytes;
}

}  // namespace penumbra
