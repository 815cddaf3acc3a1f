#include "app/render_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "image/image_file.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/isa.hpp"
#include "scene/scene.hpp"

namespace penumbra {
namespace {

// The numbers of "AxB" or "A,B,C,D"; empty if the text is anything else.
std::vector<int> whole_numbers(std::string_view text, char separator) {
  std::vector<int> numbers;
  const char* p = text.data();
  const char* end = p + text.size();
  while (true) {
    int value = 0;
    const auto result = std::from_chars(p, end, value);
    if (result.ec != std::errc{}) return {};
    numbers.push_back(value);
    if (result.ptr == end) return numbers;
    if (*result.ptr != separator) return {};
    p = result.ptr + 1;
  }
}

void set_size(RenderOptions& options, const std::string& text) {
  const std::vector<int> n = whole_numbers(text, 'x');
  if (n.size() != 2 || n[0] < 1 || n[1] < 1 || n[0] > 65536 || n[1] > 65536 ||
      static_cast<std::int64_t>(n[0]) * n[1] > (1 << 28)) {
    throw CLI::ValidationError("--size", fmt::format("expected WxH with 1 to 65536 pixels each and at most 2^28 in "
                                                     "all, such as 640x480; found `{}`",
                                                     text));
  }
  options.size = {n[0], n[1]};
}

void set_crop(RenderOptions& options, const std::string& text) {
  const std::vector<int> n = whole_numbers(text, ',');
  if (n.size() != 4 || n[0] < 0 || n[1] < 0 || n[2] <= n[0] || n[3] <= n[1]) {
    throw CLI::ValidationError("--crop", fmt::format("expected x0,y0,x1,y1 with 0 <= x0 < x1 and 0 <= y0 < y1, half "
                                                     "open, from the top left; found `{}`",
                                                     text));
  }
  options.crop = Crop{n[0], n[1], n[2], n[3]};
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

void set_lens_model(RenderOptions& options, const std::string& name) {
  for (const LensModel model : {LensModel::thin, LensModel::cone}) {
    if (lens_model_names[static_cast<int>(model)] == name) {
      options.lens_model = model;
      return;
    }
  }
  throw CLI::ValidationError("--lens-model", fmt::format("there is no lens model `{}`; there are {}", name,
                                                         fmt::join(lens_model_names, ", ")));
}

std::string names_of(std::span<const Kernel* const> kernels) {
  std::vector<std::string_view> names;
  for (const Kernel* kernel : kernels) names.emplace_back(kernel->isa);
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

void set_isa(RenderOptions& options, const std::string& name) {
  options.kernel = kernel_from_name(usable_kernels(), name);
  if (options.kernel) return;
  if (std::find(std::begin(isa_names), std::end(isa_names), name) == std::end(isa_names)) {
    throw CLI::ValidationError(
        "--isa", fmt::format("there is no instruction set `{}`; there are {}", name, names_of(usable_kernels())));
  }
  if (!kernel_from_name(built_kernels(), name)) {
    throw CLI::ValidationError(
        "--isa", fmt::format("this program was not built for {}; there are {}", name, names_of(usable_kernels())));
  }
  throw CLI::ValidationError("--isa",
                             fmt::format("this machine cannot run {}; there are {}", name, names_of(usable_kernels())));
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
  render
      ->add_option("--rays", options.rays,
                   "Rays per pixel; with --noise, the most [the scene's, else 1; with --noise 65536]")
      ->check(CLI::Range(1, 1 << 24));
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
          "--size", [&options](const std::string& s) { set_size(options, s); },
          "Pixels, WxH [the scene's, else 300x300]")
      ->type_name("WxH");
  render
      ->add_option_function<std::string>(
          "--crop", [&options](const std::string& s) { set_crop(options, s); },
          "Render only these pixels, x0,y0,x1,y1, half open, from the top left [all]")
      ->type_name("x0,y0,x1,y1");
  render
      ->add_option_function<std::string>(
          "--sampler",
          [&options](const std::string& name) {
            options.sampler = pattern_from_name(name);
            if (!options.sampler) {
              throw CLI::ValidationError("--sampler", fmt::format("there is no pattern `{}`; there are {}", name,
                                                                  fmt::join(pattern_names, ", ")));
            }
          },
          fmt::format("Sample pattern: {} [the scene's, else {}]", fmt::join(pattern_names, ", "),
                      pattern_names[static_cast<int>(default_pattern)]))
      ->type_name("NAME");
  render->add_option("--seed", options.seed, "Seed of the sample pattern [the scene's, else 0]");
  render->add_option("--max-depth", options.max_depth, "Depth at which no further ray is sent [the scene's, else 8]")
      ->check(CLI::Range(0, most_depth));
  const CLI::Range rays_of_hit(1, 65536);
  render
      ->add_option("--reflection-rays", options.reflection_rays,
                   "Reflected rays from what an eye ray hits [the scene's, else 1]")
      ->check(rays_of_hit);
  render
      ->add_option("--transmission-rays", options.transmission_rays,
                   "Transmitted rays from what an eye ray hits [the scene's, else 1]")
      ->check(rays_of_hit);
  render
      ->add_option("--shadow-rays", options.shadow_rays,
                   "Shadow rays from what an eye ray hits to each disk light [the scene's, else 1]")
      ->check(rays_of_hit);
  render
      ->add_option_function<std::string>(
          "--sampler-light", [&options](const std::string&) { options.regular_lights = true; },
          "regular: area lights are sampled at a fixed regular set of points [as --sampler says]")
      ->check(CLI::IsMember({"regular"}).description(""))
      ->type_name("regular");
  render->add_flag("--no-shadows", options.no_shadows, "Every light reaches every surface [off]");
  render->add_flag("--transparent-shadows", options.transparent_shadows,
                   "Shadow rays pass translucent surfaces, times k_trans for each [off]");
  render
      ->add_option_function<std::string>(
          "--lens-model", [&options](const std::string& name) { set_lens_model(options, name); },
          "thin: rays from the lens; cone: from the eye, within the cone of blur of what the pinhole sees [thin]")
      ->type_name("thin|cone");
  render->add_option("--time", options.time, "Freeze the shutter at this time [the scene's shutter]")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double time = 0;
            const bool good = CLI::detail::lexical_cast(text, time) && std::abs(time) <= 1e6;
            return good ? std::string() : fmt::format("expected a time from -1e6 to 1e6; found `{}`", text);
          },
          ""));
  render->add_option("--threads", options.threads, "Threads [all processors this process may use]")
      ->check(CLI::Range(1, 4096));
  render
      ->add_option_function<std::string>(
          "--isa", [&options](const std::string& name) { set_isa(options, name); },
          fmt::format("Instruction set: {} [the widest that can run here]", fmt::join(isa_names, ", ")))
      ->type_name("NAME");
  render->add_flag("--course", options.course, "The course's own picture, to the pixel [off]");
  render->add_flag("--lenient", options.lenient, "Skip commands that only other programs know, with a warning [off]");
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
  render->add_option("--stats", options.stats, "Write what the render did, as JSON")->type_name("FILE.json");
  render->add_flag("--quiet", options.quiet, "Print nothing but errors [off]");
  render->final_callback([&options] {
    check_outputs(options);
    check_noise(options);
  });
  return render;
}

}  // namespace penumbra
