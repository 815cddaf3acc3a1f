#include "rendering/call_counts.hpp"

#include <dlfcn.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

std::atomic<std::uint64_t> allocations{0}, locks{0};

// Counts, then calls the real function of that name.
template <class Lock>
int count_and_lock(const char* name, Lock* lock) {
  locks.fetch_add(1, std::memory_order_relaxed);
  return reinterpret_cast<int (*)(Lock*)>(dlsym(RTLD_NEXT, name))(lock);
}

}  // namespace

// An executable's own functions take precedence over those of all libraries.
extern "C" {

// glibc's own functions, under the names that it provides for this.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }
int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  *result = memalign(alignment, size);
  return *result ? 0 : ENOMEM;
}
// Memory straight from the kernel counts, too (base/zeroed_pages.hpp).
void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return reinterpret_cast<void*>(syscall(SYS_mmap, address, size, protection, flags, file, offset));
}

int pthread_mutex_lock(pthread_mutex_t* lock) noexcept { return count_and_lock("pthread_mutex_lock", lock); }
int pthread_mutex_trylock(pthread_mutex_t* lock) noexcept { return count_and_lock("pthread_mutex_trylock", lock); }
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept { return count_and_lock("pthread_rwlock_rdlock", lock); }
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept { return count_and_lock("pthread_rwlock_wrlock", lock); }
int pthread_spin_lock(pthread_spinlock_t* lock) noexcept { return count_and_lock("pthread_spin_lock", lock); }
}

namespace penumbra::test {

CallCounts call_counts() { return {allocations.load(), locks.load()}; }

}  // namespace penumbra::test
