// Whole files in and out. A file is written beside its place under a temporary name, forced to the disk and then
// renamed, so that whoever looks sees the old file or the new one and never a half. A run that fails or is killed
// leaves the old file, or none; what a killed run leaves behind is removed by the next write to the same target. In the
// seconds after a write, a power cut may bring the old file back, or none, unless the folder is forced to the disk too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace penumbra {

// A file that cannot be read or written: one sentence for the user, and the exit code of <sysexits.h> that tells what
// kind of trouble it is: 65 the content is damaged, 66 no such input, 73 cannot be created, 74 input or output error.
struct FileError : std::runtime_error {
  FileError(int code, const std::string& sentence) : std::runtime_error(sentence), exit_code(code) {}
  int exit_code;
};

// Makes `bytes` the content of the file `path`. A symbolic link is followed, and the file it names is replaced; an
// existing file keeps its permissions, a new one gets those of the umask. What is not a regular file (a pipe, a
// terminal, /dev/stdout) is written to directly. Throws FileError: 73 when the file cannot be created, 74 when writing
// it failed; the old file is then untouched and the temporary one removed.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

// The same, and the file that is replaced stays, under the name of previous_of(path). There is always a whole file
// under one of the two names, if there was one before.
void write_file_keeping_previous(const std::filesystem::path& path, std::span<const std::byte> bytes);

// Forces the folder of such a file to the disk, which takes as long as writing a small file. The file is complete and
// in its place already: where this cannot be done, nothing is said.
void force_folder_of(const std::filesystem::path& path);

// `path`, or where that is a link what it leads to, with `.previous` after it.
std::filesystem::path previous_of(const std::filesystem::path& path);

// Removes such a file, its previous one, and what killed runs left beside them. Throws FileError 73.
void remove_file_and_previous(const std::filesystem::path& path);

// The content of the file `path`. Throws FileError: 66 when it cannot be opened, 74 when it cannot be read.
std::vector<std::byte> read_file(const std::filesystem::path& path);

}  // namespace penumbra
