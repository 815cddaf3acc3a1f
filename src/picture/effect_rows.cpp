// Options that set the strength of an effect, for everything that has it or for one thing by its number.
#include <fmt/ranges.h>

#include "picture/option_rows.hpp"
#include "picture/option_text.hpp"
#include "picture/scene_lines.hpp"
#include "picture/scene_traits.hpp"

namespace penumbra::option_rows {
namespace {

using Options = PictureOptions;

// A row for the radii of lights or surfaces, chosen by number.
template <auto asked, auto set>
PictureOption radii(std::string_view name, std::string help, std::string_view command) {
  PictureOption row{name, "[N:]R", std::move(help), command, OptionUse::everywhere, true};
  row.parse = [](Options& options, std::string_view text) { return parse_radius(text, options.*asked); };
  row.words = [](const Options& options, const Settings&) { return radii_in_words(options.*asked); };
  row.apply = [](Scene& scene, const Options& options) { set(scene, options.*asked); };
  return row;
}

// Why radii change nothing: no thing has the effect, or those that are named do not. `has(i)`: thing i, from 0, has it.
template <class Has>
std::string why_idle(const std::vector<NumberedRadius>& radii, std::size_t count, const Has& has, std::string_view none,
                     std::string_view not_this) {
  bool any = radii.empty();
  for (std::size_t i = 0; i < count; i++) any = any || has(i);
  if (!any) return std::string(none);
  for (const NumberedRadius& r : radii) {
    const auto number = static_cast<std::size_t>(r.number);
    if (number > 0 && number <= count && !has(number - 1)) return fmt::format(fmt::runtime(not_this), number);
  }
  return {};
}

template <auto asked, double Surface::*share>
std::string why_idle_surfaces(const Scene& scene, const Options& options, std::string_view none,
                              std::string_view not_this) {
  return why_idle(
      options.*asked, scene.surfaces.size(), [&scene](std::size_t i) { return scene.surfaces[i].*share != 0; }, none,
      not_this);
}

// Why an effect that is left out would not be there anyway; empty if it would.
std::string why_not_there(const Scene& scene, Effect effect) {
  switch (effect) {
    case Effect::antialiasing:
      return scene.settings.rays_per_pixel > 1 ? "" : "there is one ray per pixel";
    case Effect::lens:
      return has_lens(scene) ? "" : "there is no lens";
    case Effect::motion:
      return moves(scene) ? "" : "nothing moves";
    case Effect::disk_lights:
      return has_area_light(scene) ? "" : "no light has an area";
    case Effect::gloss:
      return is_glossy(scene) ? "" : "no reflection is blurred";
    case Effect::translucency:
      return is_translucent(scene) ? "" : "no transmission is blurred";
  }
  return {};
}

// A knob for the radius of the light or surface with this number.
template <auto asked>
Knob radius_knob(std::string_view label, int number, double now) {
  return {std::string(label), Knob::Kind::real, now, 0, 1e6, [number](Options& options, double value) {
            std::erase_if(options.*asked, [number](const NumberedRadius& r) { return r.number == number; });
            (options.*asked).push_back({number, value});
          }};
}

// A knob for the radius of each surface with some `share` of reflected or transmitted light.
template <auto asked, double Surface::*share, double Surface::*radius>
std::vector<Knob> surface_knobs(const Scene& scene, std::string_view name) {
  std::vector<Knob> knobs;
  for (int number = 1; const Surface& surface : scene.surfaces) {
    if (surface.*share != 0) {
      knobs.push_back(radius_knob<asked>(name, number, surface.*radius));
      knobs.back().surface = number;
    }
    number++;
  }
  return knobs;
}

}  // namespace

PictureOption disk_radius() {
  PictureOption row = radii<&Options::disk_radius, set_disk_radius>(
      "disk-radius", "Radius of all disk lights, or only of light N [the scene's]", "disk_light ... radius ...");
  row.lines = light_lines;
  row.idle = [](const Scene& scene, const Options& options) {
    const auto is_disk = [&scene](std::size_t i) { return std::holds_alternative<DiskLight>(scene.lights[i]); };
    return why_idle(options.disk_radius, scene.lights.size(), is_disk, "there is no disk light",
                    "light {} is no disk light");
  };
  row.knobs = [](const Scene& scene, const Options&) {
    std::vector<Knob> knobs;
    for (int number = 1; const Light& light : scene.lights) {
      if (const auto* disk = std::get_if<DiskLight>(&light)) {
        knobs.push_back(radius_knob<&Options::disk_radius>("radius", number, disk->radius));
        knobs.back().light = number;
      }
      number++;
    }
    return knobs;
  };
  return row;
}

PictureOption gloss() {
  PictureOption row = radii<&Options::gloss, set_gloss>(
      "gloss", "Gloss radius of all reflecting surfaces, or only of surface N [the scene's]",
      "glossy ... gloss_radius");
  row.lines = surface_lines;
  row.idle = [](const Scene& scene, const Options& options) {
    return why_idle_surfaces<&Options::gloss, &Surface::reflection>(scene, options, "no surface reflects",
                                                                    "surface {} does not reflect");
  };
  row.knobs = [](const Scene& scene, const Options&) {
    return surface_knobs<&Options::gloss, &Surface::reflection, &Surface::gloss_radius>(scene, "gloss");
  };
  return row;
}

PictureOption blur() {
  PictureOption row = radii<&Options::blur, set_blur>(
      "blur", "Blur radius of all transmitting surfaces, or only of surface N [the scene's]",
      "translucent ... blur_radius");
  row.lines = no_lines;  // --gloss has them
  row.idle = [](const Scene& scene, const Options& options) {
    return why_idle_surfaces<&Options::blur, &Surface::transmission>(scene, options, "no surface transmits light",
                                                                     "surface {} does not transmit light");
  };
  row.knobs = [](const Scene& scene, const Options&) {
    return surface_knobs<&Options::blur, &Surface::transmission, &Surface::blur_radius>(scene, "blur");
  };
  return row;
}

PictureOption without() {
  PictureOption row{"without",
                    "LIST",
                    fmt::format("Leave out effects: {} [none]", fmt::join(effect_names, ",")),
                    "",
                    OptionUse::everywhere,
                    true};
  row.parse = [](Options& options, std::string_view text) {
    const std::optional<Effect> effect = value_named<Effect>(text, effect_names);
    if (!effect) return unknown("effect", text, listed(effect_names));
    options.without.add(*effect);
    return std::string();
  };
  row.words = [](const Options& options, const Settings&) { return to_string(options.without); };
  row.apply = [](Scene& scene, const Options& options) { leave_out(scene, options.without); };
  row.idle = [](const Scene& scene, const Options& options) {
    if (options.without.empty()) return std::string();
    Options others = options;
    others.without = {};
    const Scene with = with_options(scene, others);
    for (int i = 0; i < effect_count; i++) {
      const auto effect = static_cast<Effect>(i);
      if (!options.without.has(effect)) continue;
      if (const std::string why = why_not_there(with, effect); !why.empty()) {
        return fmt::format("without {}, {}", effect_names[i], why);
      }
    }
    return std::string();
  };
  row.lines = [](const Scene& before, const Scene& after) {
    if (before.settings.antialiasing == after.settings.antialiasing) return std::string();
    return comment_line("without", effect_names[static_cast<int>(Effect::antialiasing)]);
  };
  row.knobs = [](const Scene&, const Options& options) {
    std::vector<Knob> knobs;
    for (int i = 0; i < effect_count; i++) {
      const auto effect = static_cast<Effect>(i);
      knobs.push_back({std::string(effect_names[i]), Knob::Kind::toggle, options.without.has(effect) ? 0.0 : 1.0, 0, 1,
                       [effect](Options& o, double) { o.without.toggle(effect); }});
    }
    return knobs;
  };
  row.each_side = true;
  return row;
}

}  // namespace penumbra::option_rows
