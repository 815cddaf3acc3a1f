#include "app/finished_files.hpp"

#include <algorithm>

#include "app/part_file.hpp"
#include "base/archive.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"
#include "rendering/shard_part.hpp"

namespace penumbra {

std::string content_key(const PictureKey& key, const Development& development) {
  ArchiveWriter archive;
  serialize(archive, key);
  ContentHasher hasher;
  hasher.add(archive.bytes());
  const std::string rest = to_bytes(development);
  hasher.add(std::as_bytes(std::span(rest)));
  return to_hex(hasher.value());
}

bool is_finished_picture(const std::filesystem::path& file, const std::string& content) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  try {
    const Metadata metadata = read_image(file).metadata;
    return std::find(metadata.begin(), metadata.end(), std::pair<std::string, std::string>(content_entry, content)) !=
           metadata.end();
  } catch (const FileError&) {
    return false;
  }
}

bool is_finished_part(const std::filesystem::path& file, const PictureKey& key, const Shard& shard,
                      const Development& development) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  try {
    const std::vector<std::byte> bytes = read_file(file);
    const std::string name = file.string();
    const Part part(part_in_file(bytes, name), name);
    return difference(key, part.header().key).empty() && part.header().shard == shard &&
           part.header().development == to_bytes(development);
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace penumbra
