#include "picture/picture_options.hpp"

#include <fmt/format.h>

#include <span>

#include "picture/option_table.hpp"

namespace penumbra {
namespace {

std::string beyond(std::span<const NumberedRadius> radii, std::size_t count, const char* option, const char* things) {
  for (const NumberedRadius& radius : radii) {
    if (static_cast<std::size_t>(radius.number) <= count) continue;
    return fmt::format("{} names number {}, but the number of {} is {}", option, radius.number, things, count);
  }
  return {};
}

}  // namespace

std::string missing_number(const Scene& scene, const PictureOptions& options) {
  const std::size_t surfaces = scene.surfaces.size();
  if (auto text = beyond(options.gloss, surfaces, "--gloss", "surfaces"); !text.empty()) return text;
  if (auto text = beyond(options.blur, surfaces, "--blur", "surfaces"); !text.empty()) return text;
  return beyond(options.disk_radius, scene.lights.size(), "--disk-radius", "lights");
}

Scene with_options(Scene scene, const PictureOptions& options) {
  for (const PictureOption& row : option_table()) {
    if (row.apply) row.apply(scene, options);
  }
  return scene;
}

}  // namespace penumbra
