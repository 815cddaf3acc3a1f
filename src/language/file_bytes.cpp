#include "language/file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include "language/near_word.hpp"

namespace penumbra {
namespace {

constexpr std::size_t smallest_mapped = std::size_t{16} << 20;
constexpr std::size_t most_names = 10'000;  // of a folder, when a near one is looked for

// Closes a descriptor at the end of a scope.
struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

std::string system_message(int code) { return std::generic_category().message(code); }

// Reads up to `size` bytes; fewer if the file ends before. `expected` bytes are there to be read, as far as is known.
std::string read_all(int descriptor, std::uint64_t size, std::size_t expected, int& error_code) {
  std::string text;
  std::size_t done = 0;
  while (done < size) {
    if (done == text.size()) text.resize(std::min(size, std::max<std::uint64_t>(expected, 2 * done)));
    const ssize_t count = ::read(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) error_code = errno;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  text.resize(done);
  return text;
}

std::string too_large(std::uint64_t most) { return fmt::format("it has more than {} bytes", most); }

LoadedFile failure(std::string problem) {
  LoadedFile failed;
  failed.problem = std::move(problem);
  return failed;
}

// The name of the file in the folder of `path` that was probably meant; empty if none is near.
std::string near_file(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  for (std::filesystem::directory_iterator at(folder, error), end; at != end && names.size() < most_names;
       at.increment(error)) {
    if (at->is_regular_file(error)) names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return std::string(nearest_word(path.filename().string(), {names.begin(), names.end()}));
}

bool is_named_for_scenes(const std::filesystem::path& path) {
  const std::filesystem::path ending = path.extension();
  return ending == ".cli" || ending == ".obj" || ending == ".ply";
}

LoadedFile load(const std::filesystem::path& path, bool may_map) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.number < 0) {
    const int code = errno;
    LoadedFile missing = failure(system_message(code));
    if (code == ENOENT) missing.near = near_file(path);
    return missing;
  }
  struct stat status {};
  if (::fstat(file.number, &status) != 0) return failure(system_message(errno));
  if (S_ISDIR(status.st_mode)) return failure("it is a folder");
  if (!S_ISREG(status.st_mode)) return failure("it is not a regular file");

  if (static_cast<std::uint64_t>(status.st_size) > most_bytes_read) return failure(too_large(most_bytes_read));

  LoadedFile loaded;
  loaded.is_secret = (status.st_mode & S_IROTH) == 0 && !is_named_for_scenes(path);
  loaded.identity = std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino);
  const auto size = static_cast<std::size_t>(status.st_size);
  if (may_map && size >= smallest_mapped) {
    loaded.bytes = FileBytes(MappedFile(file.number, size));
    if (!loaded.bytes.view().empty()) return loaded;
  }
  int error_code = 0;
  loaded.bytes = FileBytes(read_all(file.number, size, size, error_code));
  if (error_code != 0) return failure(system_message(error_code));
  return loaded;
}

}  // namespace

LoadedFile load_from_disk(const std::filesystem::path& path) { return load(path, true); }
LoadedFile load_copy_from_disk(const std::filesystem::path& path) { return load(path, false); }

LoadedFile load_standard_input() {
  struct stat status {};
  const bool is_device = ::fstat(STDIN_FILENO, &status) == 0 && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode));
  if (is_device && ::isatty(STDIN_FILENO) == 0) return failure("standard input is a device");
  static int error_code = 0;
  static const std::string text = read_all(STDIN_FILENO, most_bytes_from_pipe + 1, 65'536, error_code);
  if (error_code != 0) return failure(system_message(error_code));
  if (text.size() > most_bytes_from_pipe) return failure(too_large(most_bytes_from_pipe));
  LoadedFile loaded;
  loaded.bytes = FileBytes(text);
  return loaded;
}

}  // namespace penumbra
