// ffmpeg is started without a shell. It reads the pixels from a pipe and writes the video to a file in memory, so that
// nothing is left behind whatever happens, and the output file is written like all others.
#include "app/render/video.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <sysexits.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "base/atomic_file.hpp"
#include "base/child_signals.hpp"
#include "base/write_all.hpp"
#include "image/image_file.hpp"
#include "image/quantize.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr int video_descriptor = 3;  // ffmpeg's

[[noreturn]] void fail(const fs::path& video, const std::string& why) {
  throw FileError(EX_CANTCREAT, fmt::format("cannot make the video `{}`: {}", video.string(), why));
}

// A file descriptor that closes itself.
class OpenFile {
 public:
  explicit OpenFile(int fd = -1) : fd_(fd) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int get() const { return fd_; }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }

 private:
  int fd_;
};

// The pixels as bytes r, g, b.
std::vector<std::uint8_t> bytes_of(const Image& image) {
  std::vector<std::uint8_t> bytes(image.rgb.size());
  for (std::size_t i = 0; i < bytes.size(); i++) {
    bytes[i] = quantize_8(image.rgb[i]);
  }
  return bytes;
}

// Every player plays yuv420p. It needs even sides, so an odd one gets a black line.
std::vector<std::string> arguments_for(int width, int height, double frames_per_second) {
  return {"ffmpeg",
          "-loglevel",
          "error",
          "-f",
          "rawvideo",
          "-pixel_format",
          "rgb24",
          "-video_size",
          fmt::format("{}x{}", width, height),
          "-framerate",
          fmt::format("{}", frames_per_second),
          "-i",
          "pipe:0",
          "-vf",
          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-pix_fmt",
          "yuv420p",
          "-fflags",
          "+bitexact",
          "-flags:v",
          "+bitexact",
          "-f",
          "mp4",
          "-y",
          fmt::format("/dev/fd/{}", video_descriptor)};
}

// A running ffmpeg.
class Ffmpeg {
 public:
  // ffmpeg reads from `input` and writes to `output`.
  Ffmpeg(const fs::path& program, std::vector<std::string> arguments, int input, int output, const fs::path& video) {
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, output, video_descriptor);
    const int error = ::posix_spawn(&pid_, program.c_str(), &files, ChildSignals().get(), words.data(), environ);
    ::posix_spawn_file_actions_destroy(&files);
    if (error != 0) {
      pid_ = -1;
      fail(video, fmt::format("`{}` does not start: {}", program.string(), std::strerror(error)));
    }
  }
  ~Ffmpeg() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGTERM);
    wait();
  }
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;

  // Waits until it ends. Returns whether it succeeded.
  bool wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t pid_ = -1;
};

}  // namespace

fs::path find_ffmpeg() {
  const char* const variable = std::getenv("PATH");
  std::string_view folders = variable ? variable : "";
  while (!folders.empty()) {
    const std::string_view folder = folders.substr(0, folders.find(':'));
    folders.remove_prefix(std::min(folder.size() + 1, folders.size()));
    fs::path program = fs::path(folder) / "ffmpeg";
    std::error_code error;
    if (!folder.empty() && fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  throw FileError(EX_UNAVAILABLE,
                  "--video needs the program ffmpeg, which is not installed (Debian: apt install ffmpeg)");
}

void write_video(const fs::path& video, const std::vector<fs::path>& pictures, double frames_per_second,
                 const fs::path& ffmpeg) {
  const Image first = read_image(pictures.front()).image;
  const OpenFile memory(::memfd_create("video", MFD_CLOEXEC));
  int ends[2];
  if (memory.get() < 0 || ::pipe2(ends, O_CLOEXEC) != 0) fail(video, std::strerror(errno));
  OpenFile read_end(ends[0]), write_end(ends[1]);
  Ffmpeg running(ffmpeg, arguments_for(first.width, first.height, frames_per_second), read_end.get(), memory.get(),
                 video);
  read_end.close();
  for (const fs::path& picture : pictures) {
    const Image image = read_image(picture).image;
    if (image.width != first.width || image.height != first.height) {
      throw FileError(EX_DATAERR, fmt::format("cannot make the video `{}`: `{}` and `{}` differ in size",
                                              video.string(), picture.string(), pictures.front().string()));
    }
    const std::vector<std::uint8_t> pixels = bytes_of(image);
    if (write_all(write_end.get(), std::as_bytes(std::span(pixels))) != 0) break;
  }
  write_end.close();
  if (!running.wait()) fail(video, "ffmpeg failed");
  const std::vector<std::byte> bytes = read_file(fmt::format("/proc/self/fd/{}", memory.get()));
  if (bytes.empty()) fail(video, "ffmpeg wrote nothing");
  write_file_atomically(video, bytes);
}

}  // namespace penumbra
