#include "app/options/session_options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "picture/option_text.hpp"

namespace penumbra {
namespace {

// The seconds of "90", "1.5s", "5m", "2h" or "1d"; none for any other text.
std::optional<double> seconds_of(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  if (unit == "m" || unit == "min") number *= 60;
  if (unit == "h") number *= 3600;
  if (unit == "d") number *= 86400;
  const bool is_known = unit.empty() || unit == "s" || unit == "m" || unit == "min" || unit == "h" || unit == "d";
  return is_known && number > 0 && number <= longest_duration ? std::optional(number) : std::nullopt;
}

template <class Number>
TakeText into_seconds(Number& seconds) {
  return [&seconds](std::string_view text) {
    const std::optional<double> found = seconds_of(text);
    if (found) seconds = *found;
    return found ? std::string() : expected(text, "a time such as 30s, 5m or 2h");
  };
}

std::string take_shard(std::optional<Shard>& result, std::string_view text) {
  Shard shard;
  const char* const last = text.data() + text.size();
  const auto index = std::from_chars(text.data(), last, shard.index);
  bool good = index.ec == std::errc{} && index.ptr != last && *index.ptr == '/';
  if (good) {
    const auto count = std::from_chars(index.ptr + 1, last, shard.count);
    good = count.ec == std::errc{} && count.ptr == last && shard.index >= 0 && shard.index < shard.count &&
           shard.count <= most_shards;
  }
  if (!good) return expected(text, fmt::format("i/n with 0 <= i < n <= {}", most_shards));
  result = shard;
  return {};
}

}  // namespace

std::vector<CommandOption> session_options(RenderSessionOptions& options) {
  return {
      {"--checkpoint", "FILE", "Save the progress of the render here at regular times [no]", into(options.checkpoint)},
      {"--every", "TIME", "Time between two checkpoints: 30s, 5m, 2h [30s]", into_seconds(options.every)},
      {"--keep-checkpoint", "",
       "Keep the checkpoint of a finished picture: --resume with more --rays goes on from it [off]",
       into(options.keep_checkpoint)},
      {"--resume", "", "Resume from the checkpoint, if there is one; skip frames that are finished [off]",
       into(options.resume)},
      {"--time-limit", "TIME", "After this time, write picture and checkpoint as they stand, exit code 75 [none]",
       into_seconds(options.time_limit)},
      {"--shard", "i/n", "Render tiles i of n, i from 0, to -o PART.exr, for `penumbra merge` [all]",
       [&options](std::string_view text) { return take_shard(options.shard, text); }},
      {"--scene-hash", "HASH", "Refuse to render unless the scene, with the files it reads, has this hash [any]",
       into(options.scene_hash)}};
}

}  // namespace penumbra
