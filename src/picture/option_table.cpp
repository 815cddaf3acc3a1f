#include "picture/option_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/version.hpp"
#include "picture/option_rows.hpp"

namespace penumbra {

namespace {

template <option_rows::MakeRow&... make_row>
std::span<const PictureOption> table_of() {
  static const std::vector<PictureOption> table{make_row()...};
  return table;
}

template <class Words, class IsWanted>
void add_words(Words& words, const Scene& scene, const PictureOptions& options, const IsWanted& is_wanted) {
  for (const PictureOption& row : option_table()) {
    if (!is_wanted(row.use)) continue;
    if (std::string said = row.words(options, scene.settings); !said.empty())
      words.emplace_back(row.name, std::move(said));
  }
}

}  // namespace

std::span<const PictureOption> option_table() {
  using namespace option_rows;
  return table_of<size, rays, sampler, filter, seed, max_depth, branching, reflection_rays, transmission_rays,
                  shadow_rays, light_rays, sampler_light, crop, noise, first_rays, shutter, time, frames, frame, eye,
                  uvw, lens, disk_radius, gloss, blur, without, exposure, course, highlight, lenient, no_shadows,
                  lens_model, transparent_shadows, aov, bits>();
}

const PictureOption& option_named(std::string_view name) {
  const std::span<const PictureOption> table = option_table();
  return *std::find_if(table.begin(), table.end(), [&](const PictureOption& row) { return row.name == name; });
}

std::string parse_option(const PictureOption& option, PictureOptions& options, std::string_view text) {
  while (option.is_list && text.find(',') != text.npos) {
    const std::size_t comma = text.find(',');
    if (std::string wrong = option.parse(options, text.substr(0, comma)); !wrong.empty()) return wrong;
    text.remove_prefix(comma + 1);
  }
  return option.parse(options, text);
}

std::vector<std::string> idle_options(const Scene& scene, const PictureOptions& options) {
  std::vector<std::string> sentences;
  for (const PictureOption& row : option_table()) {
    const std::string why = row.idle != nullptr ? row.idle(scene, options) : std::string();
    if (!why.empty()) sentences.push_back(fmt::format("--{} changes nothing: {}", row.name, why));
  }
  return sentences;
}

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
