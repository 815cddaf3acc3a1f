#include "app/frame_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string_view>

namespace penumbra {
namespace {

// Takes a number of digits alone off `text`.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || text.front() == '-') return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take(std::string_view& text, char letter) {
  if (text.empty() || text.front() != letter) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<FrameRange> range_from(std::string_view text) {
  const auto first = take_number(text);
  if (!first || !take(text, '-')) return std::nullopt;
  const auto last = take_number(text);
  if (!last) return std::nullopt;
  const auto step = take(text, 'x') ? take_number(text) : 1;
  if (!step || !text.empty()) return std::nullopt;
  if (*first > *last || *last > last_possible_frame || *step < 1) return std::nullopt;
  return FrameRange{*first, *last, *step};
}

FrameRange checked_range(const std::string& text) {
  const std::optional<FrameRange> range = range_from(text);
  if (!range) {
    throw CLI::ValidationError("--frames", fmt::format("expected A-B or A-BxSTEP with 0 <= A <= B <= {} and STEP 1 or "
                                                       "more; found `{}`",
                                                       last_possible_frame, text));
  }
  return *range;
}

}  // namespace

void add_frame_options(CLI::App& command, FrameOptions& options) {
  CLI::Option* const frames =
      command
          .add_option_function<std::string>(
              "--frames", [&options](const std::string& text) { options.range = checked_range(text); },
              "Render an animation, from frame A to frame B, each STEP-th of them [no]")
          ->type_name("A-B[xSTEP]");
  command.add_option("--frame", options.only, "Of these frames, render this one alone [all]")
      ->type_name("N")
      ->needs(frames);
  CLI::Option* const video =
      command.add_option("--video", options.video, "All frames as a video too, .mp4, by means of ffmpeg [none]")
          ->type_name("FILE.mp4")
          ->needs(frames);
  command.add_option("--fps", options.frames_per_second, "Frames of the video in a second [24]")
      ->check(CLI::Range(0.1, 1000.0).description(""))
      ->type_name("N")
      ->needs(video);
}

void check_frame_options(const FrameOptions& options) {
  if (options.only && (*options.only < options.range->first || *options.only > options.range->last)) {
    throw CLI::ValidationError("--frame", fmt::format("{} is none of the frames {}-{}", *options.only,
                                                      options.range->first, options.range->last));
  }
  if (options.video.empty()) return;
  if (std::filesystem::path(options.video).extension() != ".mp4") {
    throw CLI::ValidationError("--video", fmt::format("`{}` does not end in .mp4", options.video));
  }
  if (options.only) throw CLI::ValidationError("--video", "a video is made of all frames; leave out --frame");
}

std::vector<std::optional<FrameOfRange>> frames_to_render(const FrameOptions& options) {
  if (!options.range) return {std::nullopt};
  const FrameRange& range = *options.range;
  if (options.only) return {FrameOfRange{range.first, range.last, *options.only}};
  std::vector<std::optional<FrameOfRange>> frames;
  for (std::int64_t frame = range.first; frame <= range.last; frame += range.step) {
    frames.push_back(FrameOfRange{range.first, range.last, static_cast<int>(frame)});
  }
  return frames;
}

std::filesystem::path with_frame_number(const std::filesystem::path& file, const FrameOfRange& frame) {
  const std::size_t digits = std::max<std::size_t>(fmt::formatted_size("{}", frame.last), 4);
  const std::string name =
      fmt::format("{}.{:0{}}{}", file.stem().string(), frame.frame, digits, file.extension().string());
  return file.parent_path() / name;
}

}  // namespace penumbra
