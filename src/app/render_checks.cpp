#include "app/render_checks.hpp"

#include <fmt/format.h>

#include "image/image_file.hpp"

namespace penumbra {
namespace {

constexpr int exit_usage = 64;
constexpr int exit_cannot_create = 73;

}  // namespace

int check_before_rendering(const RenderOptions& options, const std::vector<Action>& actions,
                           const std::vector<std::vector<std::filesystem::path>>& files) {
  std::size_t number = 0;
  for (const Action& action : actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    const Scene scene = with_options(*picture->scene, options);
    if (const std::string missing = missing_number(scene, options); !missing.empty()) {
      fmt::print(stderr, "penumbra: {}\n", missing);
      return exit_usage;
    }
    if (options.crop && (options.crop->x1 > scene.settings.width || options.crop->y1 > scene.settings.height)) {
      fmt::print(stderr, "penumbra: --crop goes beyond the picture, which has {}x{} pixels\n", scene.settings.width,
                 scene.settings.height);
      return exit_usage;
    }
    if (const auto& debug = options.debug_pixel;
        debug && (debug->x >= scene.settings.width || debug->y >= scene.settings.height || debug->sample >= scene.settings.rays_per_pixel)) {
      fmt::print(stderr, "penumbra: --debug-pixel is not in the picture, which has {}x{} pixels with {} samples each\n",
                 scene.settings.width, scene.settings.height, scene.settings.rays_per_pixel);
      return exit_usage;
    }
    if (const Pattern pattern = scene.settings.pattern; options.noise && needs_count(pattern)) {
      fmt::print(stderr,
                 "penumbra: --noise needs a sample pattern that can go on, and `{}` is made for one number of rays; "
                 "use --sampler {}\n",
                 pattern_names[static_cast<int>(pattern)], pattern_names[static_cast<int>(default_pattern)]);
      return exit_usage;
    }
    for (const std::filesystem::path& path : files[number++]) {
      if (format_of(path) == ImageFormat::none) {
        fmt::print(stderr,
                   "penumbra: cannot write `{}`: the name ends neither in .png nor in .exr; name another "
                   "file with -o\n",
                   path.string());
        return exit_cannot_create;
      }
      const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
      if (!std::filesystem::is_directory(folder)) {
        fmt::print(stderr, "penumbra: cannot write `{}`: there is no folder `{}`\n", path.string(), folder.string());
        return exit_cannot_create;
      }
    }
  }
  if (number > 1 && !options.frames.video.empty()) {
    fmt::print(stderr, "penumbra: a video is made of one picture a frame, and this scene has {}\n", number);
    return exit_usage;
  }
  return 0;
}

}  // namespace penumbra
