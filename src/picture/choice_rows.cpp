// Options of what random numbers choose beside the places of samples: how far from the pixel, which branches of a tree
// of rays, which lights.
#include "picture/option_rows.hpp"
#include "picture/option_text.hpp"
#include "tracing/frame.hpp"

namespace penumbra::option_rows {
namespace {

using Options = PictureOptions;

}  // namespace

PictureOption filter() {
  PictureOption row{"filter", "NAME",
                    "How what lies round a pixel's centre counts in its colour: box (the pixel alone), triangle, "
                    "gaussian [the scene's, else box]",
                    "filter name"};
  row.parse = [](Options& options, std::string_view text) {
    return parse_name<PixelFilter>("filter", text, pixel_filter_names, options.filter);
  };
  row.words = [](const Options& options, const Settings& settings) {
    const bool said = options.filter || settings.filter != PixelFilter::box;
    return said ? std::string(pixel_filter_names[static_cast<int>(settings.filter)]) : std::string();
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.filter) scene.settings.filter = *options.filter;
  };
  row.idle = [](const Scene& scene, const Options& options) {
    if (!options.filter || *options.filter == PixelFilter::box) return std::string();
    return std::string(
        filters(with_options(scene, options))
            ? ""
            : "with one ray per pixel, with --course and without antialiasing, rays stay in their pixels");
  };
  return row;
}

PictureOption branching() {
  PictureOption row{
      "branching", "full|auto",
      "Where surfaces reflect and transmit: full traces both rays; auto, where they are worth little, one "
      "of them, unless all pixels have one ray [the scene's, else auto; with --course full]",
      "branching full|auto"};
  row.parse = [](Options& options, std::string_view text) {
    return parse_name<Branching>("branching", text, branching_names, options.branching);
  };
  row.words = [](const Options& options, const Settings& settings) {
    const bool said = options.branching || settings.branching != Settings().branching;
    return said ? std::string(branching_names[static_cast<int>(settings.branching)]) : std::string();
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.branching) scene.settings.branching = *options.branching;
  };
  row.idle = [](const Scene& scene, const Options& options) {
    if (!options.branching) return std::string();
    Scene open = with_options(scene, options);
    open.settings.branching = Branching::automatic;
    return std::string(chooses_branches(open) ? ""
                                              : "with one ray per pixel, with --course and where no surface both "
                                                "reflects and transmits, all rays are traced");
  };
  return row;
}

PictureOption light_rays() {
  PictureOption row{
      "light-rays", "N|auto",
      "Shadow rays per hit in all, each to a light that is chosen by what it can bring; 0: to all lights; "
      "auto: to all up to 64 lights, else 24 [the scene's, else auto; with --course and with one ray per "
      "pixel 0]",
      "light_rays n"};
  row.parse = [](Options& options, std::string_view text) {
    if (text == "auto") {
      options.light_rays = automatic_light_rays;
      return std::string();
    }
    return parse_whole(text, 0, most_hit_rays, options.light_rays);
  };
  row.words = [](const Options& options, const Settings& settings) {
    if (settings.light_rays != automatic_light_rays) return fmt::format("{}", settings.light_rays);
    return std::string(options.light_rays ? "auto" : "");
  };
  row.apply = [](Scene& scene, const Options& options) {
    if (options.light_rays) scene.settings.light_rays = *options.light_rays;
  };
  row.idle = [](const Scene& scene, const Options& options) {
    const bool is_idle =
        options.light_rays && (scene.lights.empty() || *options.light_rays >= int64_t(scene.lights.size()));
    return std::string(is_idle ? "there are no more lights than that" : "");
  };
  row.lines = [](const Scene& before, const Scene& after) {
    const int now = after.settings.light_rays;
    if (now == before.settings.light_rays) return std::string();
    return now == automatic_light_rays ? "# without light_rays\n" : fmt::format("light_rays {}\n", now);
  };
  return row;
}

}  // namespace penumbra::option_rows
