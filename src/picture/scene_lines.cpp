#include "picture/scene_lines.hpp"

#include <fmt/format.h>

#include "picture/option_table.hpp"

namespace penumbra {
namespace {

std::string words(Vec3 v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

std::string surface_line(const Surface& s) {
  const std::string colors = words(s.diffuse) + ' ' + words(s.specular);
  if (s.transmission != 0) {
    return fmt::format("translucent {} {} {} {} {} {} {}\n", colors, s.specular_power, s.reflection, s.gloss_radius,
                       s.transmission, s.refraction_index, s.blur_radius);
  }
  return fmt::format("glossy {} {} {} {}\n", colors, s.specular_power, s.reflection, s.gloss_radius);
}

std::string texture_line(const Surface& s) {
  constexpr const char* lines[] = {"", "noise {}\n", "wood\n", "marble\n", "stone\n"};  // in the order of Texture
  return fmt::format(fmt::runtime(lines[static_cast<std::size_t>(s.texture)]), s.texture_scale);
}

// `glossy` and `translucent` can express neither ambient light nor an open highlight.
bool has_command(const Surface& s) {
  return !s.open_highlight && s.ambient.x == 0 && s.ambient.y == 0 && s.ambient.z == 0;
}

}  // namespace

std::string size_lines(const Scene& before, const Scene& after) {
  const Settings& then = before.settings;
  const Settings& now = after.settings;
  if (now.width == then.width && now.height == then.height) return {};
  return fmt::format("image_size {} {}\n", now.width, now.height);
}

std::string eye_lines(const Scene& before, const Scene& after) {
  return after.camera.eye == before.camera.eye ? std::string() : fmt::format("eye {}\n", words(after.camera.eye));
}

std::string uvw_lines(const Scene& before, const Scene& after) {
  const Camera& then = before.camera;
  const Camera& now = after.camera;
  if (now.right == then.right && now.up == then.up && now.back == then.back) return {};
  return fmt::format("uvw {}  {}  {}\n", words(now.right), words(now.up), words(now.back));
}

std::string lens_lines(const Scene& before, const Scene& after) {
  const Camera& then = before.camera;
  const Camera& now = after.camera;
  if (now.lens_radius == then.lens_radius && now.focus_distance == then.focus_distance) return {};
  return fmt::format("lens {} {}\n", now.lens_radius, now.focus_distance);
}

std::string shutter_lines(const Scene& before, const Scene& after) {
  const Camera& then = before.camera;
  const Camera& now = after.camera;
  if (now.shutter_open == then.shutter_open && now.shutter_close == then.shutter_close) return {};
  return fmt::format("shutter {} {}\n", now.shutter_open, now.shutter_close);
}

// The command has to stand before the surfaces.
std::string highlight_lines(const Scene& before, const Scene& after) {
  for (std::size_t i = 0; i < after.surfaces.size(); i++) {
    const Highlight now = after.surfaces[i].highlight;
    if (now == before.surfaces[i].highlight) continue;
    return fmt::format("# before the surfaces: highlight {}\n", highlight_names[static_cast<int>(now)]);
  }
  return {};
}

std::string surface_lines(const Scene& before, const Scene& after) {
  std::string text;
  for (std::size_t i = 0; i < after.surfaces.size(); i++) {
    const Surface& s = after.surfaces[i];
    Surface then = before.surfaces[i];
    then.highlight = s.highlight;
    if (s == then) continue;
    if (has_command(s)) {
      text += surface_line(s) + texture_line(s);
    } else {
      text += fmt::format("# surface {}: gloss radius {}, blur radius {}; there is no command for them\n", i + 1,
                          s.gloss_radius, s.blur_radius);
    }
  }
  return text;
}

std::string light_lines(const Scene& before, const Scene& after) {
  std::string text;
  for (std::size_t i = 0; i < after.lights.size(); i++) {
    const auto* point = std::get_if<PointLight>(&after.lights[i]);
    if (point && !std::holds_alternative<PointLight>(before.lights[i])) {
      text += fmt::format("point_light {} {}\n", words(point->position), words(point->color));
    }
    const auto* now = std::get_if<DiskLight>(&after.lights[i]);
    const auto* then = std::get_if<DiskLight>(&before.lights[i]);
    if (!now || !then || now->radius == then->radius) continue;
    text += fmt::format("disk_light {} {} {} {}\n", words(now->center), now->radius, words(now->direction),
                        words(now->color));
  }
  return text;
}

std::string no_lines(const Scene&, const Scene&) { return {}; }

std::string comment_line(std::string_view option, std::string_view words) {
  return fmt::format("# --{}{}{}: there is no command for it\n", option, words.empty() ? "" : " ", words);
}

std::string changed_lines(const Scene& scene, const PictureOptions& options) {
  const Scene after = with_options(scene, options);
  std::string text;
  for (const PictureOption& row : option_table()) {
    const std::string said = row.words(options, after.settings);
    if (row.lines) {
      text += row.lines(scene, after);
    } else if (row.command.empty()) {
      if (!said.empty()) text += comment_line(row.name, row.metavar.empty() ? "" : said);
    } else if (said != row.words({}, scene.settings)) {
      text += fmt::format("{} {}\n", row.command.substr(0, row.command.find(' ')), said);
    }
  }
  return text;
}

}  // namespace penumbra
