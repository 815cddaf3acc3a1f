// Reads and writes whole files. A file is written beside its target under a temporary name, forced to the disk and then
// renamed, so that a reader sees the old file or the new one, never half a file. A run that fails or is killed leaves
// the old file, or none; the next write to the same target removes what a killed run left behind. In the seconds after
// a write, a power cut may bring back the old file, or none, unless the folder is forced to the disk too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace penumbra {

// A file that cannot be read or written: one sentence for the user, and the exit code from <sysexits.h> for the kind of
// error: 65 damaged content, 66 no such input, 73 cannot be created, 74 input or output error.
struct FileError : std::runtime_error {
  FileError(int code, const std::string& sentence) : std::runtime_error(sentence), exit_code(code) {}
  int exit_code;
};

// Makes `bytes` the content of the file `path`. A symbolic link is followed, and the file it names is replaced; an
// existing file keeps its permissions, a new one gets those of the umask. Anything but a regular file (a pipe, a
// terminal, /dev/stdout) is written to directly. Throws FileError: 73 when the file cannot be created, 74 when writing
// it fails; the old file is then untouched and the temporary one removed.
//
// The old file may stay under the name previous_of(path). If there was a file before, one of the two names then always
// holds a whole file.
enum class OldFile { goes, stays_as_previous };
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                           OldFile old_file = OldFile::goes);

// Finds out, by creating the temporary file of such a write and removing it again, what would keep the write from
// beginning. Throws the same FileError 73.
void try_to_write(const std::filesystem::path& path);

// Forces the folder of such a file to the disk, which takes as long as writing a small file. The file is complete and
// in place already, so failure is not reported.
void force_folder_of(const std::filesystem::path& path);

// The file at the end of a chain of symbolic links; it need not exist. Throws FileError 73 if the links form a circle.
std::filesystem::path target_of_links(const std::filesystem::path& path);

// The same, with `.previous` appended.
std::filesystem::path previous_of(const std::filesystem::path& path);

// Removes such a file, if there is one, and what killed runs left beside it. Throws FileError 73.
void remove_file(const std::filesystem::path& path);

// The content of the regular file `path`. If its first bytes, 4096 or all, are not wanted, only those are returned.
// Throws FileError: 66 when it cannot be opened or is of another kind, 65 when it is larger than the memory, 74 when it
// cannot be read.
using IsWanted = std::function<bool(std::span<const std::byte>)>;
std::vector<std::byte> read_file(const std::filesystem::path& path, const IsWanted& is_wanted = {});

}  // namespace penumbra
