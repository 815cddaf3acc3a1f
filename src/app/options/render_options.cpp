#include "app/options/render_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/options/shared_options.hpp"
#include "app/render/outputs.hpp"
#include "app/render/render_command.hpp"
#include "base/parse.hpp"
#include "image/image_file.hpp"
#include "picture/option_text.hpp"
#include "rendering/adaptive.hpp"

namespace penumbra {
namespace {

constexpr std::array<std::string_view, 5> progress_styles = {"auto", "bar", "plain", "json", "none"};

std::string take_progress(RenderOptions& options, std::string_view text) {
  const auto found = value_named<ProgressStyle>(text, progress_styles);
  if (!found) return expected(text, "auto, bar, plain, json or none");
  options.progress = *found;
  return {};
}

std::string take_debug_pixel(RenderOptions& options, std::string_view text) {
  const std::vector<int> n = whole_numbers(text, ',');
  if (n.size() != 3 || n[0] < 0 || n[1] < 0 || n[2] < 0) {
    return expected(text, "x,y,sample, all counted from 0, x and y from the top left");
  }
  options.debug_pixel = DebugPixel{n[0], n[1], n[2]};
  return {};
}

std::string take_frames_per_second(RenderOptions& options, std::string_view text) {
  return parse_number(text, 0.1, 1000, "a number from 0.1 to 1000", options.frames_per_second);
}

TakeText into_seconds(std::optional<double>& seconds) {
  return [&seconds](std::string_view text) {
    const std::optional<double> found = seconds_from(text, 1);
    if (!found || *found > longest_duration) return expected(text, "a time such as 30s, 5m or 2h");
    seconds = *found;
    return std::string();
  };
}

TakeText into_bytes(std::optional<std::uint64_t>& bytes) {
  return [&bytes](std::string_view text) {
    bytes = bytes_from(text);
    return bytes ? std::string() : expected(text, "a size such as 500M, 4G or 1.5T");
  };
}

std::string take_shard(std::optional<Shard>& result, std::string_view text) {
  const std::vector<int> n = whole_numbers(text, '/');
  if (n.size() != 2 || n[0] < 0 || n[0] >= n[1] || n[1] > most_shards) {
    return expected(text, fmt::format("i/n with 0 <= i < n <= {}", most_shards));
  }
  result = Shard{n[0], n[1]};
  return {};
}

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

std::string check_frames(const RenderOptions& options) {
  if (!options.frames) {
    if (options.frame) return "--frame: it needs --frames";
    if (options.frames_per_second) return "--fps: it needs --frames and --video";
    return options.video.empty() ? "" : "--video: it needs --frames";
  }
  const AnimationRange& range = *options.frames;
  if (options.frame && (*options.frame < range.first || *options.frame > range.last)) {
    return fmt::format("--frame: {} is not one of the frames {}-{}", *options.frame, range.first, range.last);
  }
  if (options.video.empty()) return options.frames_per_second ? "--fps: it needs --video" : "";
  if (std::filesystem::path(options.video).extension() != ".mp4") {
    return fmt::format("--video: `{}` does not end in .mp4", options.video);
  }
  if (has_standard_output(options.outputs)) return "--video: it is made from the files of the frames; name one with -o";
  if (options.frame) return "--video: a video is made of all frames; leave out --frame";
  if (options.session.shard) return "--video: a shard is only a part of each frame; leave out --video";
  return {};
}

std::string check_session(const RenderOptions& options) {
  const RenderSessionOptions& session = options.session;
  if (session.every && session.checkpoint.empty()) return "--every: it needs --checkpoint";
  if (session.keep_checkpoint && session.checkpoint.empty()) return "--keep-checkpoint: it needs --checkpoint";
  if (session.resume && session.checkpoint.empty() && !session.animation) {
    return "--resume: there is nothing to resume without --checkpoint or --frames";
  }
  if (options.debug_pixel &&
      (!session.checkpoint.empty() || session.time_limit || session.shard || !options.video.empty())) {
    return "--debug-pixel: nothing is rendered; leave out --checkpoint, --time-limit, --shard and --video";
  }
  return {};
}

std::string check_outputs(const RenderOptions& options) {
  bool any_exr = false;
  for (const std::string& output : options.outputs) {
    const ImageFormat format = format_of(output);
    any_exr |= format == ImageFormat::exr;
    if (format == ImageFormat::none) return fmt::format("-o: `{}` ends neither in .png nor in .exr", output);
  }
  if (options.session.shard && (options.outputs.size() != 1 || !any_exr)) {
    return "--shard: a shard is written to one file, which ends in .exr: -o PART.exr";
  }
  if (options.layers.any() && !any_exr) {
    return "--aov: layers are written to EXR files only: name one with -o OUT.exr";
  }
  return {};
}

std::string check_noise(const RenderOptions& options) {
  if (options.noise && options.rays && *options.rays < static_cast<int>(fewest_adaptive_rays)) {
    return fmt::format("--rays: with --noise it is the most rays a pixel gets, at least {}", fewest_adaptive_rays);
  }
  if (options.first_rays && !options.noise) return "--first-rays: it needs --noise";
  if (options.noise && options.regular_lights) {
    return "--sampler-light: a regular set needs a fixed number of rays; leave out --noise";
  }
  return {};
}

std::string check(RenderOptions& options) {
  options.session.animation = options.frames.has_value();
  for (const auto& part : {check_frames, check_session, check_outputs, check_noise}) {
    if (std::string wrong = part(options); !wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace

Subcommand render_subcommand(RenderOptions& options) {
  Subcommand render{"render", "Render the pictures of a scene", {}, {}, {}, {}, {}, {}};
  std::vector<CommandOption>& all = render.options;
  const auto add = [&all](std::vector<CommandOption> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  add({{"SCENE", "FILE", "The scene file (.cli); - for standard input", into(options.scene), Times::once, true},
       {"-o,--output", "FILE",
        "A file for the picture, .png or .exr, or - for a PNG on standard output; may be repeated",
        into_outputs(options.outputs), Times::repeated}});
  add(picture_options(options, false));
  add({paths_option(options)});
  add({{"--debug-pixel", "x,y,sample",
        "Render nothing; print all rays of one sample of a pixel, each with its hit and the colour it returned [off]",
        [&options](std::string_view text) { return take_debug_pixel(options, text); }}});
  add(machine_options(options.machine));
  add({{"--memory-limit", "SIZE",
        "Refuse a picture that would take more memory in all than this: 500M, 4G [what is available]",
        into_bytes(options.memory_limit)},
       {"--progress", "STYLE", "How to show progress: auto, bar, plain, json, none [auto]",
        [&options](std::string_view text) { return take_progress(options, text); }}});
  add(session_options(options.session));
  add({{"--video", "FILE.mp4", "Also write all frames as a video, .mp4, with ffmpeg [none]", into(options.video)},
       {"--fps", "N", "Frames per second of the video [24]",
        [&options](std::string_view text) { return take_frames_per_second(options, text); }},
       {"--stats", "FILE.json", "Write statistics of the render as JSON [no]", into(options.stats)},
       {"--quiet", "", "Print nothing but errors [off]", into(options.quiet)}});
  render.check = [&options] { return check(options); };
  render.run = [&options] { return render_command(options); };
  return render;
}

}  // namespace penumbra
