#include "rendering/tile_refinement.hpp"

#include "rendering/portion.hpp"
#include "rendering/saved_sums.hpp"

namespace penumbra {
namespace {

// Below this many samples a half is not rendered in two parts: packets would not be filled.
constexpr std::uint32_t fewest_samples_in_parts = 32;

ColorSum color_sum(const FilmView& film, std::size_t pixel) {
  return {film.color[3 * pixel], film.color[3 * pixel + 1], film.color[3 * pixel + 2]};
}

// False, and nothing done, if it was stopped.
bool double_samples(int x, int y, PixelNoise& noise, const TileRefinement::Place& place, RayCounts& counts,
                    const RenderState& state) {
  const FilmView view = place.film.view();
  const std::size_t pixel = static_cast<std::size_t>(y - view.y0) * static_cast<std::size_t>(view.width) +
                            static_cast<std::size_t>(x - view.x0);
  const Crop here{x, y, x + 1, y + 1};
  const auto render = [&](std::uint32_t first, std::uint32_t end) {
    return render_portions(view, place.frame, place.kernel, here, {first, end}, counts, state);
  };
  const SavedSums all_before(view, pixel);
  const ColorSum before = color_sum(view, pixel);
  const std::uint32_t n = noise.samples();
  const bool in_parts = n >= fewest_samples_in_parts;
  const std::uint32_t half_way = in_parts ? n + n / 2 : 2 * n;
  bool complete = render(n, half_way);
  const ColorSum middle = color_sum(view, pixel);
  complete = complete && render(half_way, 2 * n);
  if (!complete) {
    all_before.put_back(view, pixel);
    return false;
  }
  const ColorSum end = color_sum(view, pixel);
  const SquaredDifference parts = squared_difference(middle - before, end - middle, n / 2.0);
  noise = doubled_noise(noise, before, end - before, in_parts ? &parts : nullptr);
  place.film.set_samples(here, 2 * n);
  return true;
}

}  // namespace

bool TileRefinement::go_on(const Place& place, RayCounts& counts, const RenderState& state) {
  do {
    if (!double_due(place, counts, state)) return false;
  } while (mark_due(place.rules));
  return true;
}

bool TileRefinement::double_due(const Place& place, RayCounts& counts, const RenderState& state) {
  for (int y = tile_.y0; y < tile_.y1; y++) {
    for (int x = tile_.x0; x < tile_.x1; x++) {
      const std::size_t i = index_of(x, y);
      if (marks_[i] != Mark::due) continue;
      if (!double_samples(x, y, window_[i], place, counts, state)) return false;
      marks_[i] = Mark::none;
    }
  }
  return true;
}

// False if no pixel is worth more samples.
bool TileRefinement::mark_due(const AdaptiveRules& rules) {
  bool any = false;
  for (int y = tile_.y0; y < tile_.y1; y++) {
    for (int x = tile_.x0; x < tile_.x1; x++) {
      const std::size_t i = index_of(x, y);
      const int level = window_[i].level;
      if (marks_[i] == Mark::at_end) continue;
      if (!rules.is_worth_more(estimate_noise(window_, i, rules.rates).squared_error, level)) continue;
      marks_[i] = level < rules.most_level ? Mark::due : Mark::at_end;
      any = any || marks_[i] == Mark::due;
    }
  }
  return any;
}

int TileRefinement::finish(const Place& place, const Crop& crop) const {
  int unfinished = 0;
  for (int y = tile_.y0; y < tile_.y1; y++) {
    for (int x = tile_.x0; x < tile_.x1; x++) {
      const std::size_t i = index_of(x, y);
      const bool inside = x >= crop.x0 && y >= crop.y0 && x < crop.x1 && y < crop.y1;
      if (inside && marks_[i] == Mark::at_end) unfinished++;
      if (place.film.layers().variance) {
        place.film.set_variance(x, y, estimate_noise(window_, i, place.rules.rates).variance);
      }
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
