#include "app/render/picture_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/merge/part_file.hpp"
#include "base/archive.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"
#include "picture/develop.hpp"
#include "rendering/shard_part.hpp"

namespace penumbra {
namespace {

bool is_finished_picture(const std::filesystem::path& file, const PictureJob& job) {
  const Metadata metadata = read_image(file).metadata;
  return std::find(metadata.begin(), metadata.end(), job.development.metadata.back()) != metadata.end();
}

bool is_finished_part(const std::filesystem::path& file, const PictureJob& job) {
  const std::vector<std::byte> bytes = read_file(file);
  const std::string name = file.string();
  const Part part(part_in_file(bytes, name), name);
  return difference(job.key, part.header().key).empty() && part.header().shard == job.plan.shard &&
         part.header().development == to_bytes(job.development);
}

}  // namespace

std::string content_key(const PictureKey& key, const Development& development) {
  ArchiveWriter archive;
  serialize(archive, key);
  ContentHasher hasher;
  hasher.add(archive.bytes());
  const std::string rest = to_bytes(development);
  hasher.add(std::as_bytes(std::span(rest)));
  return to_hex(hasher.value());
}

bool is_finished_file(const std::filesystem::path& file, const PictureJob& job, bool is_part) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  try {
    return is_part ? is_finished_part(file, job) : is_finished_picture(file, job);
  } catch (const FileError&) {
    return false;
  }
}

void encode_files(const PictureJob& job, Film film, bool finished, bool is_part,
                  const std::vector<std::filesystem::path>& files,
                  const std::function<void(const std::filesystem::path&, std::span<const std::byte>)>& write) {
  Development development = job.development;
  if (is_part) {
    if (!finished) return;  // an unfinished part is useless: the checkpoint has the progress
    const PartHeader header{job.key,         job.plan.shard, job.plan.crop,
                            job.plan.layers, film.counts(),  to_bytes(development)};
    return write(files.front(), encode_part_file(header, film));
  }
  std::vector<std::pair<std::string, std::string>>& metadata = development.metadata;
  if (!finished) std::erase_if(metadata, [](const auto& entry) { return entry.first == content_entry; });
  const ImageFile image = develop(std::move(film), development);
  const Quantization quantization{development.bits, development.rounding};
  for (const auto& path : files) write(path, encode_image(image, format_of(path), quantization));
}

}  // namespace penumbra
