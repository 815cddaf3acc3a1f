#include "app/merge/part_files.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <cstdio>

#include "app/merge/part_file.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"
#include "picture/develop.hpp"

namespace penumbra {

PartFiles read_parts(const std::vector<std::string>& names) {
  PartFiles files;
  for (const std::string& name : names) {
    try {
      files.bytes.push_back(read_file(name));
      files.parts.emplace_back(part_in_file(files.bytes.back(), name), name);
    } catch (const FileError& error) {
      files.failures.push_back({name, error});
    }
  }
  return files;
}

void write_merged(const std::vector<Part>& parts, const std::vector<std::string>& outputs, bool quiet) {
  const PartHeader& header = parts.front().header();
  Development development;
  try {
    development = development_from(header.development);
  } catch (const ArchiveError& error) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is a damaged part: {}", parts.front().name(), error.what()));
  }
  const ImageFile image = develop(merge(parts), development);
  for (const std::string& output : outputs) {
    write_image(output, image, {development.bits, development.rounding});
    force_folder_of(output);  // its parts may be removed now
    if (!quiet) {
      fmt::print(stderr, "{}: {}x{} pixels, from {} parts\n", output, header.crop.width(), header.crop.height(),
                 parts.size());
    }
  }
}

}  // namespace penumbra
