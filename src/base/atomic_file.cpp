// Whole files in and out, by POSIX calls. Temporary files are named .TARGET.PID@HOST.N.tmp: the process id shows
// whether the run that wrote them is dead, the host name where that process ran if several machines share a folder.
#include "base/atomic_file.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/parse.hpp"
#include "base/write_all.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(int exit_code, std::string_view what, const fs::path& path, int error) {
  throw FileError(exit_code, fmt::format("cannot {} `{}`: {}", what, path.string(), std::strerror(error)));
}

// An open file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return fd_; }
  // Closes now; returns the error number, 0 for none. Some network file systems report a full disk only here.
  int close() { return ::close(std::exchange(fd_, -1)) == 0 || errno == EINTR ? 0 : errno; }

 private:
  int fd_;
};

// A temporary file that removes itself unless it was renamed to its target.
struct Temporary {
  explicit Temporary(std::string name) : path(std::move(name)) {}
  ~Temporary() {
    if (!renamed) ::unlink(path.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  std::string path;
  bool renamed = false;
};

// Forces the data to the disk; returns the error number, 0 for none or where the file system cannot do it.
int sync(int fd) { return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP ? 0 : errno; }

// The descriptor that a name such as /dev/stdout stands for. Opening the name again would start at the beginning of a
// file that the shell opened for appending, and replacing it would detach the shell from its file.
std::optional<int> descriptor_named(const fs::path& path) {
  const std::string& name = path.native();
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    const auto number = number_from<int>(std::string_view(name).substr(folder.size()));
    if (number && *number >= 0) return number;
  }
  return std::nullopt;
}

void write_directly(const fs::path& path, std::span<const std::byte> bytes) {
  const std::optional<int> inherited = descriptor_named(path);
  Descriptor file(inherited ? ::fcntl(*inherited, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) fail(EX_CANTCREAT, "open", path, errno);
  if (const int error = write_all(file.get(), bytes)) fail(EX_IOERR, "write", path, error);
  if (const int error = file.close()) fail(EX_IOERR, "write", path, error);
}

const std::string& host_name() {
  static const std::string name = [] {
    std::array<char, 256> buffer{};
    if (::gethostname(buffer.data(), buffer.size() - 1) != 0) return std::string("unknown");
    return std::string(buffer.data()).substr(0, 64);
  }();
  return name;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// The prefix of the temporary files of a target. Long names are cut, because a file name has at most 255 bytes.
std::string temporary_prefix(const fs::path& target) {
  return fmt::format(".{}.", target.filename().string().substr(0, 150));
}

bool is_alive(int pid) { return ::kill(pid, 0) == 0 || errno == EPERM; }

// Removes what dead runs on this host left behind from writes to the same target. A folder that cannot be listed is no
// obstacle.
void remove_stale_temporaries(const fs::path& folder, std::string_view prefix) {
  constexpr std::string_view suffix = ".tmp";
  DIR* listing = ::opendir(folder.c_str());
  if (!listing) return;
  while (const dirent* entry = ::readdir(listing)) {
    std::string_view name = entry->d_name;
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    name.remove_prefix(prefix.size());
    const std::size_t at = name.find('@');
    if (at == name.npos || !name.substr(at + 1).starts_with(host_name() + ".")) continue;
    const std::optional<int> pid = number_from<int>(name.substr(0, at));
    if (pid && *pid > 0 && !is_alive(*pid)) ::unlinkat(::dirfd(listing), entry->d_name, 0);
  }
  ::closedir(listing);
}

// A name that no other write uses, now or later: the counter is shared by the whole process.
std::string temporary_name(const fs::path& folder, std::string_view prefix) {
  static std::atomic<unsigned> counter{0};
  return (folder / fmt::format("{}{}@{}.{}.tmp", prefix, ::getpid(), host_name(), counter++)).string();
}

// The new file also gets the old one's owner where we may set it, so that a write by root does not take it over.
void keep_permissions(int fd, const struct stat& old) {
  [[maybe_unused]] const int not_ours_to_give = ::fchown(fd, old.st_uid, old.st_gid);
  ::fchmod(fd, old.st_mode & 0777);
}

// Gives the file `target` a second name, a hard link that replaces any file of that name. False where the file system
// has no hard links.
bool link_as(const fs::path& target, const fs::path& second, const std::string& temporary_link) {
  if (::link(target.c_str(), temporary_link.c_str()) != 0) return false;
  Temporary temporary(temporary_link);
  temporary.renamed = ::rename(temporary_link.c_str(), second.c_str()) == 0;
  // If both already name the same file, rename() does nothing and returns 0.
  ::unlink(temporary_link.c_str());
  return temporary.renamed;
}

// Where a write to a path goes.
struct Target {
  fs::path file;  // at the end of all links
  std::optional<struct stat> old;
  bool in_place = false;  // a pipe, a device or a descriptor, which no other file can replace
};

Target target_of_write(const fs::path& path) {
  if (path.empty()) throw FileError(EX_CANTCREAT, "cannot create a file without a name");
  Target target{path, {}, descriptor_named(path).has_value()};
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    target.old = status;
  } else if (errno != ENOENT && !target.in_place) {
    fail(EX_CANTCREAT, "create", path, errno);
  }
  if (target.old && S_ISDIR(target.old->st_mode)) fail(EX_CANTCREAT, "create", path, EISDIR);
  target.in_place |= target.old && !S_ISREG(target.old->st_mode);
  if (target.in_place) return target;
  target.file = target_of_links(path);
  // A rename would silently replace a write-protected file.
  if (target.old && ::access(target.file.c_str(), W_OK) != 0) fail(EX_CANTCREAT, "replace", path, errno);
  return target;
}

// Creates the temporary file `name` for a write to `path`.
Descriptor create_temporary(const std::string& name, const fs::path& path) {
  // The name is ours alone, so an existing file comes from a dead run that had our process id.
  ::unlink(name.c_str());
  const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0) fail(EX_CANTCREAT, "create", path, errno);
  return Descriptor(fd);
}

void replace_file(const fs::path& path, const Target& to, std::span<const std::byte> bytes, OldFile old_file) {
  const fs::path &target = to.file, folder = folder_of(target);
  const auto& old = to.old;
  const std::string prefix = temporary_prefix(target);
  remove_stale_temporaries(folder, prefix);

  const std::string name = temporary_name(folder, prefix);
  Descriptor file = create_temporary(name, path);
  Temporary temporary(name);
  if (old) keep_permissions(file.get(), *old);
  if (const int error = write_all(file.get(), bytes)) fail(EX_IOERR, "write", path, error);
  if (const int error = sync(file.get())) fail(EX_IOERR, "write", path, error);
  if (const int error = file.close()) fail(EX_IOERR, "write", path, error);
  const bool keeps = old && old_file == OldFile::stays_as_previous;
  const fs::path previous = previous_of(target);
  const bool linked = keeps && link_as(target, previous, temporary_name(folder, prefix));
  if (keeps && !linked && ::rename(target.c_str(), previous.c_str()) != 0) {
    fail(EX_CANTCREAT, "replace", path, errno);
  }
  if (::rename(name.c_str(), target.c_str()) != 0) {
    const int error = errno;
    if (keeps && !linked) ::rename(previous.c_str(), target.c_str());
    fail(EX_CANTCREAT, "replace", path, error);
  }
  temporary.renamed = true;
}

constexpr std::size_t first_bytes = 4096;
constexpr std::size_t most_without_size = std::size_t{16} << 20;

std::size_t memory_of_machine() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

// Fills the bytes from `used` on, or as many of them as the file has. Returns how many are filled then.
std::size_t read_until_full(const fs::path& path, int fd, std::vector<std::byte>& bytes, std::size_t used) {
  while (used < bytes.size()) {
    const ssize_t count = ::read(fd, bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(EX_IOERR, "read", path, errno);
    if (count == 0) break;
    used += static_cast<std::size_t>(count);
  }
  return used;
}

}  // namespace

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes, OldFile old_file) {
  const Target target = target_of_write(path);
  if (target.in_place) return write_directly(path, bytes);
  replace_file(path, target, bytes, old_file);
}

void try_to_write(const fs::path& path) {
  const Target target = target_of_write(path);
  if (!target.in_place) {
    const std::string name = temporary_name(folder_of(target.file), temporary_prefix(target.file));
    const Descriptor file = create_temporary(name, path);
    const Temporary removed_again(name);
  } else if (const std::optional<int> inherited = descriptor_named(path)) {
    const int flags = ::fcntl(*inherited, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) fail(EX_CANTCREAT, "open", path, EBADF);
  } else if (::access(path.c_str(), W_OK) != 0) {
    fail(EX_CANTCREAT, "open", path, errno);
  }
}

void force_folder_of(const fs::path& path) {
  std::error_code error;
  const fs::path folder = folder_of(fs::weakly_canonical(path, error));
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) sync(directory.get());
}

fs::path target_of_links(const fs::path& path) {
  fs::path target = path;
  std::error_code error;
  for (int hops = 0; fs::is_symlink(target, error); hops++) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) fail(EX_CANTCREAT, "create", path, error.value());
    if (hops == 40) fail(EX_CANTCREAT, "create", path, ELOOP);
    target = target.parent_path() / next;
  }
  return target;
}

fs::path previous_of(const fs::path& path) { return target_of_links(path) += ".previous"; }

void remove_file(const fs::path& path) {
  const fs::path target = target_of_links(path);
  std::error_code error;
  fs::remove(target, error);
  if (error) fail(EX_CANTCREAT, "remove", target, error.value());
  remove_stale_temporaries(folder_of(target), temporary_prefix(target));
}

std::vector<std::byte> read_file(const fs::path& path, const IsWanted& is_wanted) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail(EX_NOINPUT, "open", path, errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(EX_IOERR, "read", path, errno);
  if (S_ISDIR(status.st_mode)) fail(EX_NOINPUT, "read", path, EISDIR);
  const auto refuse = [&path](int code, std::string_view why) {
    throw FileError(code, fmt::format("cannot read `{}`: {}", path.string(), why));
  };
  if (!S_ISREG(status.st_mode)) refuse(EX_NOINPUT, "it is not a regular file");
  const auto stated = static_cast<std::size_t>(status.st_size);
  if (stated > memory_of_machine()) refuse(EX_DATAERR, "it is larger than the memory of this machine");
  // What /proc and /sys show has no size, and some of it no end.
  const std::size_t most = stated > 0 ? stated : most_without_size;
  std::vector<std::byte> bytes(std::min(most, first_bytes));
  std::size_t used = read_until_full(path, file.get(), bytes, 0);
  const bool goes_on = used == bytes.size() && (!is_wanted || is_wanted(bytes));
  if (goes_on) {
    bytes.resize(most);
    used = read_until_full(path, file.get(), bytes, used);
  }
  if (goes_on && stated == 0 && used == most) refuse(EX_DATAERR, "it has no size and does not end");
  bytes.resize(used);
  return bytes;
}

}  // namespace penumbra
