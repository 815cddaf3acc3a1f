#include "picture/metadata.hpp"

#include "base/version.hpp"
#include "picture/option_table.hpp"

namespace penumbra {
namespace {

template <class Words, class IsWanted>
void add_words(Words& words, const Scene& scene, const PictureOptions& options, const IsWanted& is_wanted) {
  for (const PictureOption& row : option_table()) {
    if (!is_wanted(row.use)) continue;
    if (std::string said = row.words(options, scene.settings); !said.empty())
      words.emplace_back(row.name, std::move(said));
  }
}

}  // namespace

Metadata metadata_for(const std::filesystem::path& file, const Scene& scene, const PictureOptions& options) {
  Metadata metadata = {{"scene", file.filename().string()}, {"version", version}};
  add_words(metadata, scene, options,
            [](OptionUse use) { return use == OptionUse::everywhere || use == OptionUse::render; });
  return metadata;
}

PlanInWords plan_in_words(const Scene& scene, const PictureOptions& options) {
  PlanInWords words;
  add_words(words, scene, options, [](OptionUse use) { return use != OptionUse::output_only; });
  return words;
}

}  // namespace penumbra
