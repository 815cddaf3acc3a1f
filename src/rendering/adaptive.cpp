// Two rounds over the tiles of the picture. In the first, every pixel gets the same few samples, in four blocks whose
// means tell the pixel's error. In the second, each tile doubles the samples of the pixels that are worth it until none
// is left; of pixels outside the tile it knows the first round only, so that tiles do not wait for each other and no
// order of them shows.
//
// A pixel is worth more samples while its error is above the goal. That alone would spend most rays on the few noisiest
// pixels. The error of the whole picture is least, for the same number of rays, where one more ray improves all pixels
// alike, so that rays go as the square root of a pixel's variance. Thus a pixel goes on also while a ray improves it by
// more than it would improve a pixel of ordinary noise that just meets the goal.
#include "rendering/adaptive.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <mutex>
#include <thread>
#include <vector>

#include "rendering/noise_estimate.hpp"

namespace penumbra {
namespace {

constexpr int tile_size = noise_tile_size;

// The variance of single samples in a pixel of ordinary noise.
constexpr float ordinary_variance = 0.02f;

// Samples of the first round, times the goal: the error of a pixel in which they all miss something bright, as far as
// one that covers a few times 1 / samples of it is likely missed. What glows more than white needs more of them; what
// is so bright and so small that 4096 samples miss it, stays unseen.
constexpr float first_samples_times_goal = 0.15f;
constexpr int fewest_first_level = 4, most_first_level = 12;

// Below this many samples a half is not rendered in two parts: packets would not be filled.
constexpr std::uint32_t fewest_samples_in_parts = 32;

int highest_level(const NoiseGoal& goal) { return static_cast<int>(std::bit_width(goal.most_rays)) - 1; }

float brightest_glow(const Frame& frame) {
  float brightest = *std::max_element(std::begin(frame.background), std::end(frame.background));
  for (const FrameSurface& surface : frame.surfaces) {
    brightest = std::max(brightest, *std::max_element(std::begin(surface.ambient), std::end(surface.ambient)));
  }
  return brightest;
}

int first_level(const NoiseGoal& goal, const Frame& frame) {
  const float wanted = first_samples_times_goal * std::max(1.0f, brightest_glow(frame) / 2);
  int level = fewest_first_level;
  while (level < most_first_level && goal.error * static_cast<float>(1 << level) < wanted) level++;
  return std::min(level, highest_level(goal));
}

// The whole tiles that cover a crop; tiles start at the picture's top left.
Crop whole_tiles(const Crop& crop, const Frame& frame) {
  const auto down = [](int v) { return v / tile_size * tile_size; };
  const auto up = [](int v, int end) { return std::min((v + tile_size - 1) / tile_size * tile_size, end); };
  return {down(crop.x0), down(crop.y0), up(crop.x1, frame.width), up(crop.y1, frame.height)};
}

Crop with_neighbours(const Crop& crop, const Frame& frame) {
  return {std::max(crop.x0 - noise_reach, 0), std::max(crop.y0 - noise_reach, 0),
          std::min(crop.x1 + noise_reach, frame.width), std::min(crop.y1 + noise_reach, frame.height)};
}

class AdaptiveRender {
 public:
  // The film covers `tiles` and their neighbours; of unfinished pixels only those in `wanted` count.
  AdaptiveRender(Film& film, const Crop& wanted, const Crop& tiles, const Frame& frame, const Kernel& kernel,
                 const NoiseGoal& goal, RenderState& state)
      : film_(film),
        view_(film.view()),
        wanted_(wanted),
        area_(film.crop()),
        tiles_(tiles),
        frame_(frame),
        kernel_(kernel),
        state_(state),
        goal_squared_(goal.error * goal.error),
        rates_(frame.options.pattern == Pattern::random ? rates_of_independent_samples : rates_of_nets),
        first_level_(first_level(goal, frame)),
        most_level_(highest_level(goal)),
        noise_(static_cast<std::size_t>(area_.width()) * static_cast<std::size_t>(area_.height())) {}

  AdaptiveResult run(int threads) {
    const std::uint64_t first_samples = noise_.size() << first_level_;
    state_.pixel_samples_expected = 2 * first_samples;
    for_tiles(area_, threads, [&](const Crop& tile, Thread& thread) { render_first(tile, thread); });
    state_.pixel_samples_expected = first_samples + expected_samples(tiles_);
    for_tiles(tiles_, threads, [&](const Crop& tile, Thread& thread) { refine(tile, thread); });
    return {rays_, unfinished_};
  }

 private:
  struct Pixel {
    int x, y;
    std::size_t place;  // in the window
  };
  // What each thread has to itself.
  struct Thread {
    RayCounts rays;
    std::uint64_t unfinished = 0;
    NoiseWindow window;
    std::array<bool, noise_window_size * noise_window_size> at_end;
    std::vector<Pixel> active;
    std::vector<ColorSum> sums;
  };

  template <class Work>
  void for_tiles(const Crop& area, int threads, const Work& work) {
    const int columns = (area.width() + tile_size - 1) / tile_size;
    const int tiles = columns * ((area.height() + tile_size - 1) / tile_size);
    std::atomic<int> next_tile{0};
    const auto run = [&] {
      Thread thread;
      thread.active.reserve(tile_size * tile_size);
      thread.sums.resize(4 * tile_size * tile_size);
      while (!stopped()) {
        const int index = next_tile.fetch_add(1, std::memory_order_relaxed);
        if (index >= tiles) break;
        const int x0 = area.x0 + index % columns * tile_size, y0 = area.y0 + index / columns * tile_size;
        const std::uint64_t rays_before = thread.rays.total();
        work(Crop{x0, y0, std::min(x0 + tile_size, area.x1), std::min(y0 + tile_size, area.y1)}, thread);
        state_.rays.fetch_add(thread.rays.total() - rays_before, std::memory_order_relaxed);
      }
      const std::lock_guard lock(mutex_);
      rays_ += thread.rays;
      unfinished_ += thread.unfinished;
    };
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(threads, tiles) - 1;
    helpers.reserve(static_cast<std::size_t>(std::max(helper_count, 0)));
    for (int i = 0; i < helper_count; i++) helpers.emplace_back(run);
    run();
  }

  bool stopped() const { return state_.stop.load(std::memory_order_relaxed); }

  std::size_t pixel_at(int x, int y) const {
    return static_cast<std::size_t>(y - area_.y0) * static_cast<std::size_t>(area_.width()) +
           static_cast<std::size_t>(x - area_.x0);
  }

  ColorSum sum_at(std::size_t pixel) const {
    return {view_.color[3 * pixel], view_.color[3 * pixel + 1], view_.color[3 * pixel + 2]};
  }

  template <class Visit>
  static void for_pixels(const Crop& crop, const Visit& visit) {
    for (int y = crop.y0; y < crop.y1; y++) {
      for (int x = crop.x0; x < crop.x1; x++) visit(x, y);
    }
  }

  // The first round of a tile.
  void render_first(const Crop& tile, Thread& thread) {
    const std::uint32_t samples = (1u << first_level_) / 4;
    for (std::uint32_t block = 0; block < 4; block++) {
      const std::uint32_t first = block * samples;
      kernel_.render_tile(frame_, view_, {tile.x0, tile.y0, tile.x1, tile.y1, first, first + samples}, thread.rays);
      std::size_t i = block;
      for_pixels(tile, [&](int x, int y) {
        thread.sums[i] = sum_at(pixel_at(x, y));
        i += 4;
      });
    }
    std::size_t i = 0;
    for_pixels(tile, [&](int x, int y) {
      const ColorSum* s = &thread.sums[i];
      noise_[pixel_at(x, y)] = first_noise({s[0], s[1] - s[0], s[2] - s[1], s[3] - s[2]}, first_level_);
      i += 4;
    });
    const auto pixels = static_cast<std::uint64_t>(tile.width()) * static_cast<std::uint64_t>(tile.height());
    state_.pixel_samples_done.fetch_add(pixels << first_level_, std::memory_order_relaxed);
  }

  bool worth_more(float squared_error, int level) const {
    const float improvement = squared_error / static_cast<float>(1u << level);
    return squared_error > goal_squared_ || improvement * ordinary_variance > goal_squared_ * goal_squared_;
  }

  // The second round of a tile.
  void refine(const Crop& tile, Thread& thread) {
    const std::uint64_t expected = expected_samples(tile);
    load_window(tile, thread);
    do {
      find_active(tile, thread);
      for (const Pixel& p : thread.active) {
        if (stopped()) return;
        double_samples(p, thread);
      }
    } while (!thread.active.empty());
    for_pixels(tile, [&](int x, int y) {
      const std::size_t place = place_of(tile, x, y);
      film_.set_samples(x, y, thread.window[place].samples());
      if (film_.layers().variance) film_.set_variance(x, y, estimate_noise(thread.window, place, rates_).variance);
    });
    state_.pixel_samples_done.fetch_add(expected, std::memory_order_relaxed);
  }

  static std::size_t place_of(const Crop& tile, int x, int y) {
    const int column = x - tile.x0 + noise_reach, row = y - tile.y0 + noise_reach;
    return static_cast<std::size_t>(row) * noise_window_size + static_cast<std::size_t>(column);
  }

  void load_window(const Crop& tile, Thread& thread) const {
    thread.window.fill({});
    thread.at_end.fill(false);
    const Crop around = {std::max(tile.x0 - noise_reach, area_.x0), std::max(tile.y0 - noise_reach, area_.y0),
                         std::min(tile.x1 + noise_reach, area_.x1), std::min(tile.y1 + noise_reach, area_.y1)};
    for_pixels(around, [&](int x, int y) { thread.window[place_of(tile, x, y)] = noise_[pixel_at(x, y)]; });
  }

  void find_active(const Crop& tile, Thread& thread) const {
    thread.active.clear();
    for_pixels(tile, [&](int x, int y) {
      const std::size_t place = place_of(tile, x, y);
      const int level = thread.window[place].level;
      if (thread.at_end[place]) return;
      if (!worth_more(estimate_noise(thread.window, place, rates_).squared_error, level)) return;
      if (level < most_level_) {
        thread.active.push_back({x, y, place});
      } else {
        thread.at_end[place] = true;
        if (x >= wanted_.x0 && y >= wanted_.y0 && x < wanted_.x1 && y < wanted_.y1) thread.unfinished++;
      }
    });
  }

  void double_samples(const Pixel& p, Thread& thread) const {
    PixelNoise& noise = thread.window[p.place];
    const std::size_t pixel = pixel_at(p.x, p.y);
    const std::uint32_t n = noise.samples();
    const auto render = [&](std::uint32_t first, std::uint32_t end) {
      kernel_.render_tile(frame_, view_, {p.x, p.y, p.x + 1, p.y + 1, first, end}, thread.rays);
    };
    const ColorSum before = sum_at(pixel);
    if (n < fewest_samples_in_parts) {
      render(n, 2 * n);
      noise = doubled_noise(noise, before, sum_at(pixel) - before, nullptr);
      return;
    }
    const std::uint32_t half = n / 2;
    render(n, n + half);
    const ColorSum middle = sum_at(pixel);
    render(n + half, 2 * n);
    const ColorSum end = sum_at(pixel);
    const SquaredDifference parts = squared_difference(middle - before, end - middle, half);
    noise = doubled_noise(noise, before, end - before, &parts);
  }

  // How many samples the second round may take, by each pixel's own noise after the first. For the progress only.
  std::uint64_t expected_samples(const Crop& crop) const {
    std::uint64_t samples = 0;
    for_pixels(crop, [&](int x, int y) {
      const PixelNoise& noise = noise_[pixel_at(x, y)];
      float squared_error = noise.halves.clamped / (4 * (rates_.expected - 1));
      int level = first_level_;
      for (; level < most_level_ && worth_more(squared_error, level); level++) squared_error /= rates_.expected;
      samples += (std::uint64_t{1} << level) - (std::uint64_t{1} << first_level_);
    });
    return samples;
  }

  Film& film_;
  const FilmView view_;
  const Crop wanted_, area_, tiles_;
  const Frame& frame_;
  const Kernel& kernel_;
  RenderState& state_;
  const float goal_squared_;
  const NoiseRates rates_;
  const int first_level_, most_level_;
  std::vector<PixelNoise> noise_;  // after the first round, for all pixels of the film
  std::mutex mutex_;
  RayCounts rays_;
  std::uint64_t unfinished_ = 0;
};

}  // namespace

AdaptiveResult render_adaptive(Film& film, const Frame& frame, const Kernel& kernel, const Plan& plan,
                               const NoiseGoal& goal, RenderState& state) {
  const Crop tiles = whole_tiles(film.crop(), frame);
  const Crop area = with_neighbours(tiles, frame);
  if (area == film.crop()) return AdaptiveRender(film, tiles, tiles, frame, kernel, goal, state).run(plan.threads);
  Film whole(area, film.layers(), SampleCounts::per_pixel);
  const AdaptiveResult result = AdaptiveRender(whole, film.crop(), tiles, frame, kernel, goal, state).run(plan.threads);
  film = whole.cut(film.crop());
  return result;
}

}  // namespace penumbra
