#include "rendering/tile_refinement.hpp"

#include <bit>

#include "rendering/pixel_list.hpp"
#include "rendering/portion.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra {
namespace {

// Below this many samples a half is not rendered in two parts: packets would not be filled.
constexpr std::uint32_t fewest_samples_in_parts = 32;

}  // namespace

bool TileRefinement::go_on(const Place& place, RayCounts& counts, const RenderState& state) {
  do {
    if (!double_due(place, counts, state)) return false;
  } while (mark_due(place.rules));
  return true;
}

bool TileRefinement::double_due(const Place& place, RayCounts& counts, const RenderState& state) {
  std::uint32_t levels = 0;  // a bit for each that there is
  const PixelList all_due = pixels_of(tile_, [&](int x, int y) {
    const std::size_t i = index_of(x, y);
    if (marks_[i] != Mark::due) return false;
    levels |= window_[i].samples();
    return true;
  });
  for (; levels != 0; levels &= levels - 1) {
    const int level = std::countr_zero(levels);
    PixelList due;
    for (const PixelPlace& pixel : all_due.all()) {
      const std::size_t i = index_of(pixel);
      if (marks_[i] == Mark::due && window_[i].level == level) due.add(pixel);
    }
    const Portion portion = portion_for(place.frame, std::bit_ceil(due.all().size()), 1u << level);
    for (auto left = due.all(); !left.empty();) {
      const auto next = portion.next_of(left);
      if (!double_samples(next, level, place, counts, state)) return false;
      left = left.subspan(next.size());
    }
  }
  return true;
}

// Of pixels that all have 2^level samples. False, and nothing done, if it was stopped.
bool TileRefinement::double_samples(std::span<const PixelPlace> pixels, int level, const Place& place,
                                    RayCounts& counts, const RenderState& state) {
  const FilmView view = place.film.view();
  const auto render = [&](std::uint32_t first, std::uint32_t end) {
    return render_portions(view, place.frame, place.kernel, pixels, {first, end}, counts, state);
  };
  const SavedSums all_before(view, pixels);
  std::array<ColorSum, PixelList::most_pixels> before, middle;
  const std::uint32_t n = 1u << level;
  const bool in_parts = n >= fewest_samples_in_parts;
  const std::uint32_t half_way = in_parts ? n + n / 2 : 2 * n;
  for (std::size_t i = 0; i < pixels.size(); i++) before[i] = color_sum(view, pixels[i]);
  bool complete = render(n, half_way);
  for (std::size_t i = 0; i < pixels.size(); i++) middle[i] = color_sum(view, pixels[i]);
  complete = complete && render(half_way, 2 * n);
  if (!complete) {
    all_before.put_back(view, pixels);
    return false;
  }
  for (std::size_t i = 0; i < pixels.size(); i++) {
    const ColorSum end = color_sum(view, pixels[i]);
    const SquaredDifference parts = squared_difference(middle[i] - before[i], end - middle[i], n / 2.0);
    const std::size_t k = index_of(pixels[i]);
    window_[k] = doubled_noise(window_[k], before[i], end - before[i], in_parts ? &parts : nullptr);
    marks_[k] = Mark::none;
  }
  place.film.set_samples(pixels, 2 * n);
  return true;
}

// False if no pixel is worth more samples.
bool TileRefinement::mark_due(const AdaptiveRules& rules) {
  const WindowNumbers observed = observed_rates(window_, rules.rates);
  bool any = false;
  for (int y = tile_.y0; y < tile_.y1; y++) {
    for (int x = tile_.x0; x < tile_.x1; x++) {
      const std::size_t i = index_of(x, y);
      const int level = window_[i].level;
      if (marks_[i] == Mark::at_end) continue;
      if (!rules.is_worth_more(squared_error(window_, i, observed[i]), level)) continue;
      marks_[i] = level < rules.most_level ? Mark::due : Mark::at_end;
      any = any || marks_[i] == Mark::due;
    }
  }
  return any;
}

int TileRefinement::finish(const Place& place, const Crop& crop) const {
  const WindowNumbers observed = observed_rates(window_, place.rules.rates);
  int unfinished = 0;
  for (int y = tile_.y0; y < tile_.y1; y++) {
    for (int x = tile_.x0; x < tile_.x1; x++) {
      const std::size_t i = index_of(x, y);
      const bool inside = x >= crop.x0 && y >= crop.y0 && x < crop.x1 && y < crop.y1;
      if (inside && marks_[i] == Mark::at_end) unfinished++;
      if (place.film.layers().variance) place.film.set_variance(x, y, variance(window_, i, observed[i]));
    }
  }
  return unfinished;
}

template <class Archive, class Self>
void TileRefinement::exchange(Archive& archive, Self& self) {
  for (auto& noise : self.window_) exchange_noise(archive, noise);
  for (auto& mark : self.marks_) {
    auto number = static_cast<std::uint8_t>(mark);
    archive(number);
    if constexpr (Archive::reads) {
      if (number > static_cast<int>(Mark::at_end)) throw ArchiveError("a pixel has a mark that there is not");
      mark = static_cast<Mark>(number);
    }
  }
}

void TileRefinement::write(ArchiveWriter& archive) const { exchange(archive, *this); }

void TileRefinement::read(ArchiveReader& archive, const Crop& tile) {
  tile_ = tile;
  exchange(archive, *this);
}

}  // namespace penumbra
