#include "app/render/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/say.hpp"

namespace penumbra {
namespace {

using namespace std::chrono_literals;

constexpr int bar_width = 30;

std::chrono::milliseconds interval_of(ProgressStyle style) {
  switch (style) {
    case ProgressStyle::bar:
      return 100ms;
    case ProgressStyle::json:
      return 500ms;
    default:
      return 3000ms;
  }
}

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  if (seconds < 10) return fmt::format("{:.2f} s", seconds);
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  const long minutes = std::lround(seconds / 60);
  return minutes < 100 ? fmt::format("{} min", minutes) : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

Progress::Progress(ProgressStyle style, const RenderState& state, std::uint64_t total)
    : style_(style), state_(state), total_(total) {
  if (style_ == ProgressStyle::automatic) style_ = isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::plain;
  if (style_ != ProgressStyle::none) thread_ = std::jthread([this] { run(); });
}

Progress::~Progress() {
  if (style_ == ProgressStyle::none) return;
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  thread_.join();
  if (shown_ || style_ == ProgressStyle::json) show(true);
}

void Progress::run() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, interval_of(style_), [this] { return end_; })) show(false);
}

void Progress::show(bool last) {
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::uint64_t expected = state_.pixel_samples_expected.load();
  const auto total = static_cast<double>(expected > 0 ? expected : total_);
  const double done = total == 0 ? 1 : static_cast<double>(state_.pixel_samples_done.load()) / total;
  const double now_done = total == 0 ? 1 : done - static_cast<double>(state_.pixel_samples_before.load()) / total;
  const double remaining = now_done > 0 ? elapsed * std::max(1 - done, 0.0) / now_done : INFINITY;
  const double rate = static_cast<double>(state_.rays.load()) / std::max(elapsed, 1e-9);
  if (style_ == ProgressStyle::json) {
    say_progress(
        fmt::format("{{\"done\": {:.4f}, \"elapsed\": {:.3f}, \"remaining\": {}, \"rays_per_second\": {:.0f}}}\n", done,
                    elapsed, std::isfinite(remaining) ? fmt::format("{:.3f}", remaining) : "null", rate));
  } else if (style_ == ProgressStyle::bar) {
    const int filled = std::clamp(static_cast<int>(done * bar_width), 0, bar_width);
    say_progress(fmt::format("\r[{}{}] {:3.0f} %  {} elapsed, {} left, {:.1f} Mrays/s   {}", std::string(filled, '#'),
                             std::string(bar_width - filled, '.'), 100 * done, duration_text(elapsed),
                             duration_text(remaining), rate * 1e-6, last ? "\n" : ""));
  } else if (!last) {
    say_progress(fmt::format("{:3.0f} % done, {} elapsed, {} left, {:.1f} Mrays/s\n", 100 * done,
                             duration_text(elapsed), duration_text(remaining), rate * 1e-6));
  }
}

}  // namespace penumbra
