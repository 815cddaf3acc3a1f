#include "picture/metadata.hpp"

#include <fmt/format.h>

#include "base/version.hpp"

namespace penumbra {
namespace {

std::string text_of(const std::vector<NumberedRadius>& radii) {
  std::string text;
  for (const NumberedRadius& radius : radii) {
    if (!text.empty()) text += ',';
    text += radius.number == 0 ? fmt::format("{}", radius.radius) : fmt::format("{}:{}", radius.number, radius.radius);
  }
  return text;
}

}  // namespace

Metadata metadata_for(const std::filesystem::path& file, const Scene& scene, const PictureOptions& options) {
  const auto name_of = [](const auto& names, auto value) { return std::string(names[static_cast<int>(value)]); };
  Metadata metadata = {{"scene", file.filename().string()},
                       {"version", version},
                       {"size", fmt::format("{}x{}", scene.width, scene.height)},
                       {"rays", fmt::format("{}", scene.rays_per_pixel)},
                       {"sampler", name_of(pattern_names, pattern_for(scene, options))},
                       {"seed", fmt::format("{}", scene.seed)},
                       {"max-depth", fmt::format("{}", scene.max_depth)}};
  const auto add = [&metadata](const char* name, std::string value) {
    if (!value.empty()) metadata.emplace_back(name, std::move(value));
  };
  const auto add_rays = [&add](const char* name, int rays) {
    if (rays != 1) add(name, fmt::format("{}", rays));
  };
  const auto add_pair = [&add](const char* name, const std::optional<std::pair<double, double>>& pair) {
    if (pair) add(name, fmt::format("{},{}", pair->first, pair->second));
  };
  const auto add_flag = [&add](const char* name, bool set) { add(name, set ? "yes" : ""); };
  add_rays("reflection-rays", scene.reflection_rays);
  add_rays("transmission-rays", scene.transmission_rays);
  add_rays("shadow-rays", scene.shadow_rays);
  if (options.regular_lights) add("sampler-light", "regular");
  if (options.crop) {
    const Crop& c = *options.crop;
    add("crop", fmt::format("{},{},{},{}", c.x0, c.y0, c.x1, c.y1));
  }
  if (options.frame) {
    add("frames", fmt::format("{}-{}", options.frame->first, options.frame->last));
    add("frame", fmt::format("{}", options.frame->frame));
  }
  if (options.noise) add("noise", fmt::format("{}", *options.noise));
  if (options.time) add("time", fmt::format("{}", *options.time));
  add_pair("lens", options.lens);
  add_pair("shutter", options.shutter);
  add("gloss", text_of(options.gloss));
  add("blur", text_of(options.blur));
  add("disk-radius", text_of(options.disk_radius));
  add("without", to_string(options.without));
  if (options.exposure_halves != 0) add("exposure", fmt::format("{}", options.exposure_halves / 2.0));
  add_flag("course", options.course);
  add_flag("lenient", options.lenient);
  add_flag("no-shadows", options.no_shadows);
  if (options.lens_model != LensModel::thin) add("lens-model", name_of(lens_model_names, options.lens_model));
  add_flag("transparent-shadows", options.transparent_shadows);
  return metadata;
}

}  // namespace penumbra
