#include "app/sitting_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

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

double checked_seconds(const char* option, const std::string& text) {
  const std::optional<double> seconds = seconds_of(text);
  if (!seconds) {
    throw CLI::ValidationError(option, fmt::format("expected a time such as 30s, 5m or 2h; found `{}`", text));
  }
  return *seconds;
}

Shard checked_shard(const std::string& text) {
  Shard shard;
  const char* const last = text.data() + text.size();
  const auto index = std::from_chars(text.data(), last, shard.index);
  bool good = index.ec == std::errc{} && index.ptr != last && *index.ptr == '/';
  if (good) {
    const auto count = std::from_chars(index.ptr + 1, last, shard.count);
    good = count.ec == std::errc{} && count.ptr == last && shard.index >= 0 && shard.index < shard.count &&
           shard.count <= most_shards;
  }
  if (!good) {
    throw CLI::ValidationError("--shard",
                               fmt::format("expected i/n with 0 <= i < n <= {}; found `{}`", most_shards, text));
  }
  return shard;
}

}  // namespace

void add_sitting_options(CLI::App& command, SittingOptions& options) {
  CLI::Option* const checkpoint =
      command.add_option("--checkpoint", options.checkpoint, "Save here what is rendered so far, now and then [no]")
          ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--every", [&options](const std::string& text) { options.every = checked_seconds("--every", text); },
          "Time between two savings: 30s, 5m, 2h [30s]")
      ->type_name("TIME")
      ->needs(checkpoint);
  command.add_flag("--resume", options.resume,
                   "Go on from the checkpoint, if there is one; skip frames that are finished [off]");
  command
      .add_option_function<std::string>(
          "--time-limit",
          [&options](const std::string& text) { options.time_limit = checked_seconds("--time-limit", text); },
          "After this time, write the picture and the checkpoint as they are, exit code 75 [none]")
      ->type_name("TIME");
  command
      .add_option_function<std::string>(
          "--shard", [&options](const std::string& text) { options.shard = checked_shard(text); },
          "Render tiles i of n, i from 0, to -o PART.exr, for `penumbra merge` [all]")
      ->type_name("i/n");
  command
      .add_option("--scene-hash", options.scene_hash,
                  "Refuse to render if the scene, or a file it reads, has another hash than this [any]")
      ->type_name("HASH");
}

}  // namespace penumbra
