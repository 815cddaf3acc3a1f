#include "app/picture_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/arguments.hpp"
#include "picture/picture_options.hpp"

namespace penumbra {
namespace {

void set_size(PictureOptions& options, const std::string& text) {
  const std::vector<int> n = whole_numbers(text, 'x');
  if (n.size() != 2 || n[0] < 1 || n[1] < 1 || n[0] > 65536 || n[1] > 65536 ||
      static_cast<std::int64_t>(n[0]) * n[1] > (1 << 28)) {
    throw CLI::ValidationError("--size", fmt::format("expected WxH with 1 to 65536 pixels each and at most 2^28 in "
                                                     "all, such as 640x480; found `{}`",
                                                     text));
  }
  options.size = {n[0], n[1]};
}

void set_lens_model(PictureOptions& options, const std::string& name) {
  for (const LensModel model : {LensModel::thin, LensModel::cone}) {
    if (lens_model_names[static_cast<int>(model)] == name) {
      options.lens_model = model;
      return;
    }
  }
  throw CLI::ValidationError("--lens-model", fmt::format("there is no lens model `{}`; there are {}", name,
                                                         fmt::join(lens_model_names, ", ")));
}

void set_sampler(PictureOptions& options, const std::string& name) {
  options.sampler = pattern_from_name(name);
  if (options.sampler) return;
  throw CLI::ValidationError(
      "--sampler", fmt::format("there is no pattern `{}`; there are {}", name, fmt::join(pattern_names, ", ")));
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
  command
      .add_option("--rays", options.rays,
                  "Rays per pixel; with --noise, the most [the scene's, else 1; with --noise 65536]")
      ->check(CLI::Range(1, 1 << 24));
  command
      .add_option_function<std::string>(
          "--size", [&options](const std::string& s) { set_size(options, s); },
          "Pixels, WxH [the scene's, else 300x300]")
      ->type_name("WxH");
  command
      .add_option_function<std::string>(
          "--sampler", [&options](const std::string& name) { set_sampler(options, name); },
          fmt::format("Sample pattern: {} [the scene's, else {}]", fmt::join(pattern_names, ", "),
                      pattern_names[static_cast<int>(default_pattern)]))
      ->type_name("NAME");
  command.add_option("--seed", options.seed, "Seed of the sample pattern [the scene's, else 0]");
  command.add_option("--max-depth", options.max_depth, "Depth at which no further ray is sent [the scene's, else 8]")
      ->check(CLI::Range(0, most_depth));
  const CLI::Range rays_of_hit(1, 65536);
  command
      .add_option("--reflection-rays", options.reflection_rays,
                  "Reflected rays from what an eye ray hits [the scene's, else 1]")
      ->check(rays_of_hit);
  command
      .add_option("--transmission-rays", options.transmission_rays,
                  "Transmitted rays from what an eye ray hits [the scene's, else 1]")
      ->check(rays_of_hit);
  command
      .add_option("--shadow-rays", options.shadow_rays,
                  "Shadow rays from what an eye ray hits to each disk light [the scene's, else 1]")
      ->check(rays_of_hit);
  command
      .add_option_function<std::string>(
          "--sampler-light", [&options](const std::string&) { options.regular_lights = true; },
          "regular: area lights are sampled at a fixed regular set of points [as --sampler says]")
      ->check(CLI::IsMember({"regular"}).description(""))
      ->type_name("regular");
  command.add_flag("--no-shadows", options.no_shadows, "Every light reaches every surface [off]");
  command.add_flag("--transparent-shadows", options.transparent_shadows,
                   "Shadow rays pass translucent surfaces, times k_trans for each [off]");
  command
      .add_option_function<std::string>(
          "--lens-model", [&options](const std::string& name) { set_lens_model(options, name); },
          "thin: rays from the lens; cone: from the eye, within the cone of blur of what the pinhole sees [thin]")
      ->type_name("thin|cone");
  command.add_option("--time", options.time, "Freeze the shutter at this time [the scene's shutter]")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double time = 0;
            const bool good = CLI::detail::lexical_cast(text, time) && std::abs(time) <= 1e6;
            return good ? std::string() : fmt::format("expected a time from -1e6 to 1e6; found `{}`", text);
          },
          ""));
  command.add_flag("--course", options.course, "The course's own picture, to the pixel [off]");
  command.add_flag("--lenient", options.lenient, "Skip commands that only other programs know, with a warning [off]");
  add_effect_options(command, options);
}

}  // namespace penumbra
