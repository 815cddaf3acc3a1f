// Options of size, rays and samples: the settings of scene/settings.hpp, and when a pixel has enough rays.
#include <algorithm>
#include <tuple>

#include "picture/option_rows.hpp"
#include "picture/option_text.hpp"
#include "picture/scene_lines.hpp"
#include "picture/scene_traits.hpp"
#include "rendering/adaptive_rules.hpp"
#include "tracing/frame.hpp"

namespace penumbra::option_rows {
namespace {

using Options = PictureOptions;

// A row for a whole number from `low` to `high` that scenes can set, too. Without `always`, it has words only if the
// option is given or the number is not 1.
template <auto asked, auto setting, std::int64_t low, std::int64_t high, bool always>
PictureOption whole_number(std::string_view name, std::string help, std::string_view command) {
  PictureOption row{name, "N", std::move(help), command};
  row.parse = [](Options& options, std::string_view text) { return parse_whole(text, low, high, options.*asked); };
  row.words = [](const Options& options, const Settings& settings) {
    const bool said = always || options.*asked || settings.*setting != 1;
    return said ? fmt::format("{}", settings.*setting) : std::string();
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.*asked) scene.settings.*setting = *(options.*asked);
  };
  return row;
}

// A row for a flag; if it is given, the setting gets the value `then`.
template <bool Options::*asked>
PictureOption flag(std::string_view name, std::string help) {
  PictureOption row{name, "", std::move(help), ""};
  row.parse = [](Options& options, std::string_view) {
    options.*asked = true;
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) { return std::string(options.*asked ? "yes" : ""); };
  return row;
}
template <bool Options::*asked, bool Settings::*setting, bool then>
PictureOption flag(std::string_view name, std::string help) {
  PictureOption row = flag<asked>(name, std::move(help));
  row.apply = [](Scene& scene, const Options& options) {
    if (options.*asked) scene.settings.*setting = then;
  };
  return row;
}

// Why something about random numbers changes nothing; empty if there are some.
std::string why_not_random(const Scene& scene, const Options& options) {
  const bool random = is_random(with_options(scene, options));
  return random ? "" : "nothing is random with one ray per pixel and without soft effects";
}

}  // namespace

PictureOption size() {
  PictureOption row{"size", "WxH", "Size in pixels [the scene's, else 300x300]", "image_size w h"};
  row.help_of_view = "Size of the picture in pixels [the scene's, else 300x300]";
  row.parse = [](Options& options, std::string_view text) {
    const std::vector<int> n = whole_numbers(text, 'x');
    const auto is_side = [](int side) { return side >= 1 && side <= most_side; };
    if (n.size() != 2 || !is_side(n[0]) || !is_side(n[1]) || std::int64_t{n[0]} * n[1] > most_pixels) {
      return expected(text,
                      fmt::format("WxH with 1 to {} pixels each and at most 2^28 in all, such as 640x480", most_side));
    }
    options.size = {n[0], n[1]};
    return std::string();
  };
  row.words = [](const Options&, const Settings& settings) {
    return fmt::format("{}x{}", settings.width, settings.height);
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.size) std::tie(scene.settings.width, scene.settings.height) = *options.size;
  };
  row.lines = size_lines;
  return row;
}

PictureOption rays() {
  PictureOption row = whole_number<&Options::rays, &Settings::rays_per_pixel, 1, most_rays_per_pixel, true>(
      "rays", "Rays per pixel; with --noise, the most [the scene's, else 1; with --noise 65536]", "rays_per_pixel n");
  row.help_of_view = "Rays per pixel at which the picture rests [the scene's, else 1]";
  row.apply = [](Scene& scene, const Options& options) {
    if (options.noise) scene.settings.rays_per_pixel = static_cast<int>(NoiseGoal().most_rays);
    if (options.rays) scene.settings.rays_per_pixel = *options.rays;
  };
  return row;
}

PictureOption sampler() {
  PictureOption row{"sampler", "NAME",
                    fmt::format("Sample pattern: {} [the scene's, else {}; with --course random]",
                                listed(pattern_names), pattern_names[static_cast<int>(default_pattern)]),
                    "sampler name"};
  row.parse = [](Options& options, std::string_view text) {
    return parse_name<Pattern>("pattern", text, pattern_names, options.sampler);
  };
  row.words = [](const Options&, const Settings& settings) {
    return std::string(pattern_names[static_cast<int>(settings.pattern)]);
  };
  row.apply = [](Scene& scene, const Options& options) {
    // The course's pictures use independent random samples.
    if (options.course != Course::off) scene.settings.pattern = Pattern::random;
    if (options.sampler) scene.settings.pattern = *options.sampler;
  };
  row.idle = [](const Scene& scene, const Options& options) {
    return options.sampler ? why_not_random(scene, options) : std::string();
  };
  row.knobs = [](const Scene& scene, const Options&) -> std::vector<Knob> {
    const int now = static_cast<int>(scene.settings.pattern);
    return {{"sampler", Knob::Kind::choice, static_cast<double>(now), 0, 0,
             [](Options& options, double value) { options.sampler = static_cast<Pattern>(static_cast<int>(value)); },
             pattern_names}};
  };
  row.each_side = true;
  return row;
}

PictureOption seed() {
  PictureOption row = whole_number<&Options::seed, &Settings::seed, 0, 0xffffffff, true>(
      "seed", "Seed of the sample pattern [the scene's, else 0]", "seed n");
  row.idle = [](const Scene& scene, const Options& options) {
    return options.seed ? why_not_random(scene, options) : std::string();
  };
  row.knobs = [](const Scene& scene, const Options&) -> std::vector<Knob> {
    return {{"seed", Knob::Kind::whole, static_cast<double>(scene.settings.seed), 0, 0xffffffff,
             [](Options& options, double value) { options.seed = static_cast<std::uint32_t>(value); }}};
  };
  return row;
}

PictureOption max_depth() {
  PictureOption row = whole_number<&Options::max_depth, &Settings::max_depth, 0, most_depth, true>(
      "max-depth", "Depth at which no further rays are sent [the scene's, else 8]", "max_depth n");
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(
        options.max_depth && !reflects(scene) && !transmits(scene) ? "no surface reflects or transmits light" : "");
  };
  row.knobs = [](const Scene& scene, const Options&) -> std::vector<Knob> {
    return {{"max depth", Knob::Kind::slider, static_cast<double>(scene.settings.max_depth), 0, 20,
             [](Options& options, double value) { options.max_depth = static_cast<int>(value); }}};
  };
  return row;
}

PictureOption reflection_rays() {
  PictureOption row = whole_number<&Options::reflection_rays, &Settings::reflection_rays, 1, most_hit_rays, false>(
      "reflection-rays", "Reflected rays per hit of an eye ray [the scene's, else 1]", "reflection_rays n");
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.reflection_rays && !reflects(scene) ? "no surface reflects" : "");
  };
  return row;
}

PictureOption transmission_rays() {
  PictureOption row = whole_number<&Options::transmission_rays, &Settings::transmission_rays, 1, most_hit_rays, false>(
      "transmission-rays", "Transmitted rays per hit of an eye ray [the scene's, else 1]", "transmission_rays n");
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.transmission_rays && !transmits(scene) ? "no surface transmits light" : "");
  };
  return row;
}

PictureOption shadow_rays() {
  PictureOption row = whole_number<&Options::shadow_rays, &Settings::shadow_rays, 1, most_hit_rays, false>(
      "shadow-rays", "Shadow rays to each area light per hit of an eye ray [the scene's, else 1]", "shadow_rays n");
  row.idle = [](const Scene& scene, const Options& options) {
    if (!options.shadow_rays) return std::string();
    const Scene now = with_options(scene, options);
    if (chosen_light_rays(now) > 0) return std::string("light-rays says how many shadow rays there are");
    return std::string(has_area_light(now) ? "" : "no light has an area");
  };
  return row;
}

PictureOption sampler_light() {
  PictureOption row{"sampler-light", "regular",
                    "regular: area lights are sampled at a fixed regular set of points [as --sampler says]", ""};
  row.parse = [](Options& options, std::string_view text) {
    options.regular_lights = text == "regular";
    return options.regular_lights ? std::string() : unknown("pattern for lights", text, "regular");
  };
  row.words = [](const Options& options, const Settings&) {
    return std::string(options.regular_lights ? "regular" : "");
  };
  row.apply = [](Scene& scene, const Options& options) { scene.settings.regular_lights |= options.regular_lights; };
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.regular_lights && !has_area_light(with_options(scene, options)) ? "no light has an area"
                                                                                               : "");
  };
  return row;
}

PictureOption noise() {
  PictureOption row{"noise", "E",
                    "Adaptive: as many rays as each pixel needs for this standard error of colours in 0..1 [off]", "",
                    OptionUse::render};
  row.parse = [](Options& options, std::string_view text) {
    return parse_number(text, 1e-5, 1, "an error from 1e-5 to 1", options.noise);
  };
  row.words = words_if_given<&Options::noise>;
  return row;
}

PictureOption first_rays() {
  PictureOption row{"first-rays", "N",
                    "Rays of every pixel before --noise looks where more are needed; small bright objects that all of "
                    "them miss stay unseen [16 to 4096, more for a small error]",
                    "", OptionUse::render};
  row.parse = [](Options& options, std::string_view text) {
    return parse_whole(text, fewest_first_rays, NoiseGoal().most_rays, options.first_rays);
  };
  row.words = [](const Options& options, const Settings&) {
    return options.first_rays ? fmt::format("{}", *options.first_rays) : std::string();
  };
  return row;
}

PictureOption course() {
  PictureOption row{
      "course", "YEAR",
      fmt::format("Reproduce the course's own picture, pixel for pixel; of a year that drew some things in its own "
                  "way: {} [off]",
                  years_in_words),
      "course [year]"};
  row.value_is_optional = true;
  row.parse = [](Options& options, std::string_view text) {
    options.course = text.empty() || text == "yes" ? Course::any_year : course_of_year(text);
    return options.course != Course::off ? std::string() : unknown("course of", text, years_in_words);
  };
  row.words = [](const Options& options, const Settings&) {
    if (options.course == Course::any_year) return std::string("yes");
    return std::string(year_of(options.course).name);
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.course != Course::off) scene.settings.course = options.course;
  };
  row.lines = [](const Scene& before, const Scene& after) {
    const Course now = after.settings.course;
    if (now == before.settings.course) return std::string();
    return fmt::format("# in the first line: course {}\n", year_of(now).name);
  };
  return row;
}

PictureOption highlight() {
  PictureOption row{"highlight", "blinn|phong",
                    "Highlight of `surface` and `shiny`: max(0, N.H)^p or max(0, R.V)^p [the scene's, else blinn]",
                    "highlight blinn|phong"};
  row.parse = [](Options& options, std::string_view text) {
    return parse_name<Highlight>("highlight", text, highlight_names, options.highlight);
  };
  row.words = [](const Options& options, const Settings&) {
    return options.highlight ? std::string(highlight_names[static_cast<int>(*options.highlight)]) : std::string();
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (!options.highlight) return;
    for (Surface& surface : scene.surfaces) {
      if (surface.open_highlight) surface.highlight = *options.highlight;
    }
  };
  row.lines = highlight_lines;
  row.idle = [](const Scene& scene, const Options& options) {
    const auto leaves_it_open = [](const Surface& s) { return s.open_highlight && s.specular != Color{}; };
    const bool is_idle =
        options.highlight && std::none_of(scene.surfaces.begin(), scene.surfaces.end(), leaves_it_open);
    return std::string(is_idle ? "no surface leaves its highlight open" : "");
  };
  return row;
}

PictureOption lenient() {
  return flag<&Options::lenient>("lenient", "Skip commands that only other programs know, with a warning [off]");
}

PictureOption no_shadows() {
  PictureOption row =
      flag<&Options::no_shadows, &Settings::shadows, false>("no-shadows", "Every light reaches every surface [off]");
  row.idle = [](const Scene& scene, const Options& options) {
    return std::string(options.no_shadows && scene.lights.empty() ? "there is no light" : "");
  };
  return row;
}

PictureOption transparent_shadows() {
  PictureOption row = flag<&Options::transparent_shadows, &Settings::transparent_shadows, true>(
      "transparent-shadows", "Shadow rays pass translucent surfaces, multiplied by k_trans at each [off]");
  row.idle = [](const Scene& scene, const Options& options) {
    const bool is_idle = options.transparent_shadows && (options.no_shadows || !transmits(scene));
    return std::string(is_idle ? "no surface that transmits light casts a shadow" : "");
  };
  return row;
}

}  // namespace penumbra::option_rows
