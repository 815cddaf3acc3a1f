#include "app/render_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

#include "app/arguments.hpp"
#include "app/machine_arguments.hpp"
#include "app/picture_arguments.hpp"
#include "image/image_file.hpp"
#include "rendering/adaptive.hpp"

namespace penumbra {
namespace {

void set_crop(RenderOptions& options, const std::string& text) {
  const std::vector<int> n = whole_numbers(text, ',');
  if (n.size() != 4 || n[0] < 0 || n[1] < 0 || n[2] <= n[0] || n[3] <= n[1]) {
    throw CLI::ValidationError("--crop", fmt::format("expected x0,y0,x1,y1 with 0 <= x0 < x1 and 0 <= y0 < y1, half "
                                                     "open, from the top left; found `{}`",
                                                     text));
  }
  options.crop = PixelRect{n[0], n[1], n[2], n[3]};
}

void set_debug_pixel(RenderOptions& options, const std::string& text) {
  const std::vector<int> n = whole_numbers(text, ',');
  if (n.size() != 3 || n[0] < 0 || n[1] < 0 || n[2] < 0) {
    throw CLI::ValidationError("--debug-pixel", fmt::format("expected x,y,sample, all counted from 0, x and y from the "
                                                            "top left; found `{}`",
                                                            text));
  }
  options.debug_pixel = DebugPixel{n[0], n[1], n[2]};
}

void set_layers(RenderOptions& options, const std::vector<std::string>& names) {
  const std::map<std::string, bool*> layers = {{"depth", &options.layers.depth},
                                               {"normal", &options.layers.normal},
                                               {"albedo", &options.layers.albedo},
                                               {"variance", &options.layers.variance},
                                               {"samples", &options.layers.samples}};
  for (const std::string& name : names) {
    const auto layer = layers.find(name);
    if (layer == layers.end()) {
      throw CLI::ValidationError(
          "--aov", fmt::format("there is no layer `{}`; there are depth, normal, albedo, variance, samples", name));
    }
    *layer->second = true;
  }
}

void check_sitting(const RenderOptions& options) {
  const SittingOptions& sitting = options.sitting;
  if (sitting.resume && sitting.checkpoint.empty() && !sitting.animation) {
    throw CLI::ValidationError("--resume", "there is nothing to go on from without --checkpoint or --frames");
  }
  if (sitting.shard && !options.frames.video.empty()) {
    throw CLI::ValidationError("--video", "a shard is only a part of each frame; leave out --video");
  }
}

void check_debug_pixel(const RenderOptions& options) {
  const SittingOptions& sitting = options.sitting;
  if (options.debug_pixel &&
      (!sitting.checkpoint.empty() || sitting.time_limit || sitting.shard || !options.frames.video.empty())) {
    throw CLI::ValidationError("--debug-pixel",
                               "nothing is rendered; leave out --checkpoint, --time-limit, --shard and --video");
  }
}

void check_outputs(const RenderOptions& options) {
  bool any_exr = false;
  for (const std::string& output : options.outputs) {
    const ImageFormat format = format_of(output);
    any_exr |= format == ImageFormat::exr;
    if (format == ImageFormat::none) {
      throw CLI::ValidationError("-o", fmt::format("`{}` ends neither in .png nor in .exr", output));
    }
  }
  if (options.sitting.shard && (options.outputs.size() != 1 || !any_exr)) {
    throw CLI::ValidationError("--shard", "a shard is written to one file, which ends in .exr: -o PART.exr");
  }
  if (options.layers.any() && !any_exr) {
    throw CLI::ValidationError("--aov", "layers are written to EXR files only: name one with -o OUT.exr");
  }
}

void check_noise(const RenderOptions& options) {
  if (options.noise && options.rays && *options.rays < static_cast<int>(fewest_adaptive_rays)) {
    throw CLI::ValidationError(
        "--rays", fmt::format("with --noise it is the most rays a pixel gets, {} at least", fewest_adaptive_rays));
  }
  if (options.noise && options.regular_lights) {
    throw CLI::ValidationError("--sampler-light", "a regular set is made for one number of rays; leave out --noise");
  }
}

}  // namespace

CLI::App* add_render(CLI::App& app, RenderOptions& options) {
  CLI::App* render = app.add_subcommand("render", "Render the pictures of a scene");
  render->add_option("SCENE", options.scene, "The scene file (.cli)")->required();
  render->add_option("-o,--output", options.outputs, "A file for the picture, .png or .exr; may be repeated")
      ->allow_extra_args(false)
      ->type_name("FILE");
  add_picture_options(*render, options);
  render
      ->add_option("--noise", options.noise,
                   "As many rays as each pixel needs for this standard error, colours being 0..1 [off]")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double error = 0;
            const bool good = CLI::detail::lexical_cast(text, error) && error >= 1e-5 && error <= 1;
            return good ? std::string() : fmt::format("expected an error from 1e-5 to 1; found `{}`", text);
          },
          ""))
      ->type_name("E");
  render
      ->add_option_function<std::string>(
          "--crop", [&options](const std::string& s) { set_crop(options, s); },
          "Render only these pixels, x0,y0,x1,y1, half open, from the top left [all]")
      ->type_name("x0,y0,x1,y1");
  render
      ->add_option_function<std::string>(
          "--debug-pixel", [&options](const std::string& s) { set_debug_pixel(options, s); },
          "Render nothing; print all rays of one sample of one pixel, each with what it hit and what came back [off]")
      ->type_name("x,y,sample");
  add_machine_options(*render, options.threads, options.kernel);
  render->add_option("--bits", options.bits, "Bits for each colour in a PNG: 8 or 16 [8]")
      ->check(CLI::IsMember({8, 16}));
  render
      ->add_option_function<std::vector<std::string>>(
          "--aov", [&options](const std::vector<std::string>& names) { set_layers(options, names); },
          "More layers for an EXR: depth,normal,albedo,variance,samples [none]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("LAYERS");
  const std::map<std::string, ProgressStyle> styles = {{"auto", ProgressStyle::automatic},
                                                       {"bar", ProgressStyle::bar},
                                                       {"plain", ProgressStyle::plain},
                                                       {"json", ProgressStyle::json},
                                                       {"none", ProgressStyle::none}};
  render->add_option("--progress", options.progress, "How to show progress: auto, bar, plain, json, none [auto]")
      ->transform(CLI::CheckedTransformer(styles).description(""))
      ->type_name("STYLE");
  add_sitting_options(*render, options.sitting);
  add_frame_options(*render, options.frames);
  render->add_option("--stats", options.stats, "Write what the render did, as JSON")->type_name("FILE.json");
  render->add_flag("--quiet", options.quiet, "Print nothing but errors [off]");
  render->final_callback([&options] {
    options.sitting.animation = options.frames.range.has_value();
    check_frame_options(options.frames);
    check_sitting(options);
    check_debug_pixel(options);
    check_outputs(options);
    check_noise(options);
  });
  return render;
}

}  // namespace penumbra
