#include "app/render/memory_need.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>

#include "base/atomic_file.hpp"
#include "base/available_memory.hpp"
#include "rendering/film.hpp"
#include "rendering/noise_estimate.hpp"

namespace penumbra {
namespace {

constexpr std::uint64_t working_memory = 16 << 20;    // of threads and libraries, and the ends of large pages
constexpr std::uint64_t never_refused = 32 << 20;     // finding out what is available takes time
constexpr std::uint64_t rim = 2 * noise_window_size;  // more than --noise renders around a crop, on both sides

std::string in_words(std::uint64_t bytes) {
  const double megabytes = static_cast<double>(bytes) / (1 << 20);
  return megabytes < 1000 ? fmt::format("{:.0f} MB", megabytes) : fmt::format("{:.1f} GB", megabytes / 1024);
}

MemoryNeed need_of(const RenderOptions& options, int width, int height) {
  const PixelRect crop = options.crop.value_or(PixelRect{0, 0, width, height});
  const std::uint64_t pixels = crop.pixel_count();
  const std::uint64_t film = Film::bytes_per_pixel(options.layers);
  std::uint64_t bytes = film * pixels;
  if (options.noise) {
    const std::uint64_t seen = (crop.width() + rim) * (crop.height() + rim);
    const std::uint64_t state = (film + sizeof(PixelNoise)) * (options.crop ? seen : pixels);
    bytes = options.crop ? state + film * pixels : state;
  }
  const bool is_copied = options.session.shard || !options.session.checkpoint.empty();
  return {pixels, (is_copied ? 2 : 1) * bytes + working_memory};
}

}  // namespace

MemoryNeed memory_need(const RenderOptions& options, const SceneFile& file) {
  MemoryNeed most;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    const Settings& own = picture->scene->settings;
    const auto [width, height] = options.size.value_or(std::pair(own.width, own.height));
    const MemoryNeed need = need_of(options, width, height);
    if (need.bytes > most.bytes) most = need;
  }
  return most;
}

void require_memory(const MemoryNeed& need, std::optional<std::uint64_t> limit) {
  if (!limit && need.bytes <= never_refused) return;
  const std::uint64_t has = resident_memory();
  const std::uint64_t available = limit ? *limit - std::min(has, *limit) : available_memory();
  if (need.bytes <= available) return;
  throw FileError(
      EX_USAGE,
      fmt::format(
          "this render needs about {} of memory for {} pixels, beside its scene, and {} are available{}: choose "
          "a smaller --size, or {}",
          in_words(need.bytes), need.pixels, in_words(available),
          limit ? fmt::format(" of the --memory-limit of {}", in_words(*limit)) : "",
          limit ? "a higher --memory-limit"
                : fmt::format("try all the same with --memory-limit {}G", ((need.bytes + has) >> 30) + 1)));
}

}  // namespace penumbra
