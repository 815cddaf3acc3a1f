#include "app/sessions/checkpoint_file.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <new>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/say.hpp"

namespace penumbra {
namespace {

std::string in_use(const std::filesystem::path& path) {
  return fmt::format(
      "another run writes the checkpoint `{}`: wait for its end, or choose another file with --checkpoint",
      path.string());
}

// The path, unless a checkpoint can never be there.
const std::filesystem::path& possible(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error) || std::filesystem::is_regular_file(path, error)) return path;
  throw FileError(EX_CANTCREAT,
                  fmt::format("cannot write the checkpoint `{}`: it is not a regular file", path.string()));
}

}  // namespace

CheckpointFile::CheckpointFile(std::filesystem::path path, bool resume)
    : path_(std::move(path)), lock_(possible(path_), in_use(path_)) {
  require_replaceable(previous_of(path_));
  if (!resume) require_replaceable(path_);
}

// A checkpoint replaces nothing but a checkpoint.
void CheckpointFile::require_replaceable(const std::filesystem::path& file) const {
  std::error_code error;
  if (!std::filesystem::exists(file, error) || looks_like_checkpoint(file)) return;
  throw FileError(EX_CANTCREAT,
                  fmt::format("cannot write the checkpoint `{}`: it would replace `{}`, a file of another kind; choose "
                              "another name",
                              path_.string(), file.string()));
}

LastCheckpoint CheckpointFile::read() {
  LastCheckpoint last = read_last_checkpoint(path_);
  keeps_previous_ = last.warning.empty();
  return last;
}

int CheckpointFile::save(const PictureKey& key, const Spent& spent, const ResumableRender& render) {
  const std::vector<std::byte> bytes = encode(key, spent, render);
  return bytes.empty() ? EX_SOFTWARE : write(bytes);
}

std::vector<std::byte> CheckpointFile::encode(const PictureKey& key, const Spent& spent,
                                              const ResumableRender& render) {
  try {
    return encode_checkpoint(key, spent, render);
  } catch (const std::bad_alloc&) {
    report_failure("there is not enough memory", EX_SOFTWARE);
    return {};
  }
}

int CheckpointFile::write(std::span<const std::byte> bytes) {
  try {
    write_file_atomically(path_, bytes, keeps_previous_ ? OldFile::stays_as_previous : OldFile::goes);
  } catch (const FileError& error) {
    return report_failure(error.what(), error.exit_code);
  }
  force_folder_of(path_);
  keeps_previous_ = true;
  fails_ = false;
  return 0;
}

int CheckpointFile::report_failure(std::string_view why, int exit_code) {
  if (!std::exchange(fails_, true)) {
    warn(fmt::format("the checkpoint `{}` cannot be saved, and the one before it remains: {}", path_.string(), why));
  }
  return exit_code;
}

void CheckpointFile::remove() const {
  for (const std::filesystem::path& file : {path_, previous_of(path_)}) {
    try {
      if (looks_like_checkpoint(file)) remove_file(file);
    } catch (const FileError& error) {
      warn(error.what());
    }
  }
}

}  // namespace penumbra
