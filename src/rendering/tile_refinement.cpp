#include "rendering/tile_refinement.hpp"

#include <bit>

#include "rendering/pixel_list.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra {
// With fewer samples, a half is not rendered in two parts, which would not fill their packets.
constexpr std::uint32_t fewest_samples_in_parts = 32;

bool TileRefinement::go_on(const ChunkRenderer& renderer, const AdaptiveRules& rules) {
  do {
    if (!double_due(renderer)) return false;
  } while (mark_due(rules));
  return true;
}

bool TileRefinement::double_due(const ChunkRenderer& renderer) {
  const PixelRect window = window_pixels();
  std::uint32_t levels = 0;  // a bit for each that occurs
  const PixelList all_due = pixels_of(tile_, [&](int x, int y) {
    const std::size_t i = window.index_of(x, y);
    if (marks_[i] != Mark::due) return false;
    levels |= window_[i].samples();
    return true;
  });
  for (; levels != 0; levels &= levels - 1) {
    const int level = std::countr_zero(levels);
    PixelList due;
    for (const Pixel pixel : all_due.all()) {
      const std::size_t i = window.index_of(pixel);
      if (marks_[i] == Mark::due && window_[i].level == level) due.add(pixel);
    }
    const bool complete = renderer.for_chunks(
        due.all(), 1u << level, [&](const Chunk& chunk) { return double_samples(chunk, level, renderer); });
    if (!complete) return false;
  }
  return true;
}

// Doubles the samples of pixels that all have 2^level. Returns false, with nothing changed, if stopped.
bool TileRefinement::double_samples(const Chunk& chunk, int level, const ChunkRenderer& renderer) {
  const FilmView& view = renderer.view;
  const auto pixels = chunk.pixels;
  const SavedSums all_before(view, pixels);
  std::array<ColorSum, PixelList::capacity> before, middle;
  const std::uint32_t n = 1u << level;
  const bool in_parts = n >= fewest_samples_in_parts;
  const std::uint32_t half_way = in_parts ? n + n / 2 : 2 * n;
  for (std::size_t i = 0; i < pixels.size(); i++) before[i] = color_sum(view, pixels[i]);
  bool complete = renderer.render(chunk, {n, half_way});
  for (std::size_t i = 0; i < pixels.size(); i++) middle[i] = color_sum(view, pixels[i]);
  complete = complete && renderer.render(chunk, {half_way, 2 * n});
  if (!complete) {
    all_before.put_back(view, pixels);
    return false;
  }
  for (std::size_t i = 0; i < pixels.size(); i++) {
    const ColorSum end = color_sum(view, pixels[i]);
    const SquaredDifference parts = squared_difference(middle[i] - before[i], end - middle[i], n / 2.0);
    const std::size_t k = window_pixels().index_of(pixels[i]);
    window_[k] = doubled_noise(window_[k], before[i], end - before[i], in_parts ? &parts : nullptr);
    marks_[k] = Mark::none;
  }
  renderer.film.set_samples(pixels, 2 * n);
  return true;
}

// Returns false if no pixel is worth more samples.
bool TileRefinement::mark_due(const AdaptiveRules& rules) {
  const WindowNumbers observed = observed_rates(window_, rules.rates);
  bool any = false;
  for_pixels(tile_, [&](int x, int y) {
    const std::size_t i = window_pixels().index_of(x, y);
    const int level = window_[i].level;
    if (marks_[i] == Mark::at_end) return;
    if (!rules.is_worth_more(squared_error(window_, i, observed[i]), level)) return;
    marks_[i] = level < rules.most_level ? Mark::due : Mark::at_end;
    any = any || marks_[i] == Mark::due;
  });
  return any;
}

int TileRefinement::finish(Film& film, const AdaptiveRules& rules, const PixelRect& crop) const {
  const WindowNumbers observed = observed_rates(window_, rules.rates);
  int unfinished = 0;
  for_pixels(tile_, [&](int x, int y) {
    const std::size_t i = window_pixels().index_of(x, y);
    if (crop.contains(x, y) && marks_[i] == Mark::at_end) unfinished++;
    if (film.layers().has(Layer::variance)) film.set_variance(x, y, variance(window_, i, observed[i]));
  });
  return unfinished;
}

template <class Archive>
void TileRefinement::serialize_window(Archive& archive, Archived<Archive, TileRefinement>& refinement) {
  for (auto& noise : refinement.window_) serialize(archive, noise);
  for (auto& mark : refinement.marks_) serialize_enum(archive, mark, Mark::at_end);
}

void TileRefinement::write(ArchiveWriter& archive) const { serialize_window(archive, *this); }

void TileRefinement::read(ArchiveReader& archive, const PixelRect& tile) {
  tile_ = tile;
  serialize_window(archive, *this);
}

}  // namespace penumbra
