// Loaded into a program by LD_PRELOAD: makes one of its calls that write a file fail, as PENUMBRA_FAIL says:
//
//   k:ENOSPC, k:EIO   the k-th of write, fsync, link and rename fails with this error
//   k:GONE            the k-th and all after it fail with EIO
//   k:SHORT           the k-th write writes half of what it should
//   k:FULL            the same, and all writes after it fail with ENOSPC
//
// Only regular files and folders count, without the standard streams. The name of the call that failed is written to
// the file PENUMBRA_FAIL_LOG.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<int> calls{0};
std::atomic<bool> is_full{false};

struct Plan {
  int call = 0;
  const char* how = "";

  Plan() {
    const char* text = std::getenv("PENUMBRA_FAIL");
    if (!text) return;
    call = std::atoi(text);
    const char* colon = std::strchr(text, ':');
    how = colon ? colon + 1 : "";
  }
  bool is(const char* name) const { return std::strcmp(how, name) == 0; }
  bool is_of_writes() const { return is("SHORT") || is("FULL"); }
};

const Plan& plan() {
  static const Plan only;
  return only;
}

bool counts(int fd, bool folders) {
  struct stat status {};
  if (fd <= STDERR_FILENO || ::fstat(fd, &status) != 0) return false;
  return S_ISREG(status.st_mode) || (folders && S_ISDIR(status.st_mode));
}

void note(const char* name) {
  const char* path = std::getenv("PENUMBRA_FAIL_LOG");
  if (!path) return;
  const int fd = ::open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (fd < 0) return;
  ::syscall(SYS_write, fd, name, std::strlen(name));
  ::close(fd);
}

// Whether this call has to fail; if so, sets errno.
bool fails(const char* name) {
  const int call = calls.fetch_add(1) + 1;
  if (call < plan().call || (call > plan().call && !plan().is("GONE"))) return false;
  note(name);
  errno = plan().is("EIO") || plan().is("GONE") ? EIO : ENOSPC;
  return true;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int fd, const void* bytes, size_t size) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  if (!counts(fd, false)) return real(fd, bytes, size);
  if (is_full) {
    errno = ENOSPC;
    return -1;
  }
  if (fails("write")) {
    if (!plan().is_of_writes()) return -1;
    is_full = plan().is("FULL");
    return real(fd, bytes, size / 2);
  }
  return real(fd, bytes, size);
}

int fsync(int fd) {
  static auto* const real = next<int(int)>("fsync");
  if (plan().is_of_writes()) return real(fd);
  return counts(fd, true) && fails(counts(fd, false) ? "fsync" : "fsync of a folder") ? -1 : real(fd);
}

int rename(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("rename");
  return !plan().is_of_writes() && fails("rename") ? -1 : real(from, to);
}

int link(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("link");
  return !plan().is_of_writes() && fails("link") ? -1 : real(from, to);
}
}
