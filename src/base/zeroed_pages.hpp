// Memory for large arrays that begin as zeros, straight from the operating system, in huge pages where it has them. A
// picture takes tens of thousands of small pages, and handing out a few hundred of them takes a millisecond.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <utility>
#include <vector>

namespace penumbra {

template <class T>
class ZeroedPages {
 public:
  using value_type = T;

  ZeroedPages() = default;
  template <class Other>
  explicit ZeroedPages(const ZeroedPages<Other>&) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / (2 * sizeof(T))) throw std::bad_alloc();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < fewest_bytes) return static_cast<T*>(std::memset(::operator new(bytes, alignment), 0, bytes));
    // Enough to begin and end at huge pages; what is never written takes no memory.
    const std::size_t size = whole_pages(bytes);
    void* const memory = mmap(nullptr, size + large_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::size_t before = whole_pages(address) - address;
    void* const aligned = static_cast<std::byte*>(memory) + before;
    if (before > 0) munmap(memory, before);
    if (before < large_page) munmap(static_cast<std::byte*>(aligned) + size, large_page - before);
    madvise(aligned, size, MADV_HUGEPAGE);  // a hint: small pages work too, but slower
    return static_cast<T*>(aligned);
  }

  void deallocate(T* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < fewest_bytes) {
      ::operator delete(memory, alignment);
    } else {
      munmap(memory, whole_pages(bytes));
    }
  }

  // An element made without a value is 0 already: only for types that begin as zeros.
  void construct(T*) {}
  template <class... Values>
  void construct(T* place, Values&&... values) {
    ::new (static_cast<void*>(place)) T(std::forward<Values>(values)...);
  }

  bool operator==(const ZeroedPages&) const { return true; }

  static constexpr std::size_t large_page = std::size_t{2} << 20;  // bytes of a huge page

  // Whether an allocation of so many elements consists of pages of its own.
  static constexpr bool has_own_pages(std::size_t count) { return count * sizeof(T) >= fewest_bytes; }

 private:
  static constexpr std::align_val_t alignment{alignof(T)};
  // Below this, clearing a huge page takes longer than clearing a few small ones.
  static constexpr std::size_t fewest_bytes = large_page / 8;
  static std::size_t whole_pages(std::size_t bytes) { return (bytes + large_page - 1) / large_page * large_page; }
};

// A vector that shrank and grows again by resize() finds its old values there, not 0.
template <class T>
using ZeroedVector = std::vector<T, ZeroedPages<T>>;

// Gives the huge pages that lie between two elements back to the operating system: these elements are 0 afterwards. A
// small array keeps its memory, and its elements.
template <class T>
void give_back(ZeroedVector<T>& array, std::size_t first, std::size_t end) {
  using Pages = ZeroedPages<T>;
  if (!Pages::has_own_pages(array.capacity())) return;
  const std::size_t begin_byte = (first * sizeof(T) + Pages::large_page - 1) / Pages::large_page * Pages::large_page;
  const std::size_t end_byte = end * sizeof(T) / Pages::large_page * Pages::large_page;
  if (begin_byte >= end_byte) return;
  madvise(reinterpret_cast<std::byte*>(array.data()) + begin_byte, end_byte - begin_byte, MADV_DONTNEED);
}

}  // namespace penumbra
