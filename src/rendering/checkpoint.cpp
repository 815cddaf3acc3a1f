#include "rendering/checkpoint.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <array>
#include <fstream>

#include "rendering/sealed_file.hpp"

namespace penumbra {
namespace {

template <class Archive>
void serialize_head(Archive& archive, Archived<Archive, PictureKey>& key, Archived<Archive, Spent>& spent) {
  serialize(archive, key);
  for (auto& count : spent.rays.counts) archive(count);
  auto& not_finite = spent.rays.not_finite;
  archive(not_finite.count);
  archive(not_finite.x);
  archive(not_finite.y);
  archive(not_finite.sample);
  archive(spent.seconds);
}

}  // namespace

std::vector<std::byte> encode_checkpoint(const PictureKey& key, const Spent& spent, const ResumableRender& render) {
  SealedWriter file(FileKind::checkpoint);
  ArchiveWriter block;
  serialize_head(block, key, spent);
  file.add(block.bytes());
  bool first = true;
  for (int tile = 0; tile < render.grid().count(); tile++) {
    if (!render.has_begun(tile)) continue;
    block.clear();
    block(tile);
    render.write(block, tile);
    if (first) file.expect(static_cast<std::size_t>(render.grid().count()), block.bytes().size());
    first = false;
    file.add(block.bytes());
  }
  return file.finish();
}

Checkpoint::Checkpoint(std::vector<std::byte> bytes, std::string name)
    : bytes_(std::move(bytes)), name_(std::move(name)) {
  SealedReader file(bytes_, FileKind::checkpoint, name_);
  file.read(file.next(), [this](ArchiveReader& archive) { serialize_head(archive, key_, spent_); });
  while (!file.next().empty()) {
  }
}

void Checkpoint::require(const PictureKey& key) const {
  const std::string why = difference(key_, key);
  if (!why.empty()) {
    throw FileError(EX_DATAERR, fmt::format("`{}` is the checkpoint of another render: {}", name_, why));
  }
}

void Checkpoint::restore(ResumableRender& render) const {
  SealedReader file(bytes_, FileKind::checkpoint, name_);
  file.next();
  int last = -1;
  for (auto block = file.next(); !block.empty(); block = file.next()) {
    file.read(block, [&](ArchiveReader& archive) {
      int tile = 0;
      archive(tile);
      if (tile <= last || tile >= render.grid().count()) throw ArchiveError("there is no such tile");
      render.read(archive, tile);
      last = tile;
    });
  }
}

LastCheckpoint read_last_checkpoint(const std::filesystem::path& path) {
  const std::filesystem::path previous = previous_of(path);
  std::error_code error;
  const bool has_newest = std::filesystem::exists(path, error);
  const bool has_previous = std::filesystem::exists(previous, error);
  std::string trouble;
  if (has_newest) {
    try {
      return {Checkpoint(read_file(path), path.string()), {}};
    } catch (const FileError& damage) {
      if (!has_previous || damage.exit_code != EX_DATAERR) throw;
      trouble = damage.what();
    }
  } else {
    if (!has_previous) return {};
    trouble = fmt::format("there is no checkpoint `{}`", path.string());
  }
  try {
    return {Checkpoint(read_file(previous), previous.string()),
            fmt::format("{}; resuming from the previous one, `{}`", trouble, previous.string())};
  } catch (const FileError& damage) {
    throw FileError(damage.exit_code, fmt::format("{}; {}", trouble, damage.what()));
  }
}

bool looks_like_checkpoint(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, 64> start{};
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  const auto bytes = std::as_bytes(std::span(start)).first(static_cast<std::size_t>(file.gcount()));
  return is_sealed(bytes, FileKind::checkpoint);
}

}  // namespace penumbra
