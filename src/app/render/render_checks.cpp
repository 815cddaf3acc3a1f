#include "app/render/render_checks.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include "image/image_file.hpp"

namespace penumbra {
int check_before_rendering(const RenderOptions& options, const std::vector<Action>& actions,
                           const std::vector<std::vector<std::filesystem::path>>& files) {
  std::size_t number = 0;
  for (const Action& action : actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    const Scene scene = with_options(*picture->scene, options);
    const Settings& settings = scene.settings;
    if (const std::string missing = missing_number(scene, options); !missing.empty()) {
      fmt::print(stderr, "penumbra: {}\n", missing);
      return EX_USAGE;
    }
    if (options.crop && (options.crop->x1 > settings.width || options.crop->y1 > settings.height)) {
      fmt::print(stderr, "penumbra: --crop goes beyond the picture, which has {}x{} pixels\n", settings.width,
                 settings.height);
      return EX_USAGE;
    }
    if (const auto& debug = options.debug_pixel; debug && (debug->x >= settings.width || debug->y >= settings.height ||
                                                           debug->sample >= settings.rays_per_pixel)) {
      fmt::print(stderr, "penumbra: --debug-pixel is not in the picture, which has {}x{} pixels with {} samples each\n",
                 settings.width, settings.height, settings.rays_per_pixel);
      return EX_USAGE;
    }
    if (const Pattern pattern = settings.pattern; options.noise && needs_count(pattern)) {
      fmt::print(stderr,
                 "penumbra: --noise needs a sample pattern that can be extended, and `{}` has a fixed number of rays; "
                 "use --sampler {}\n",
                 pattern_names[static_cast<int>(pattern)], pattern_names[static_cast<int>(default_pattern)]);
      return EX_USAGE;
    }
    for (const std::filesystem::path& path : files[number++]) {
      if (format_of(path) == ImageFormat::none) {
        fmt::print(stderr,
                   "penumbra: cannot write `{}`: the name ends neither in .png nor in .exr; name another "
                   "file with -o\n",
                   path.string());
        return EX_CANTCREAT;
      }
      const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
      if (!std::filesystem::is_directory(folder)) {
        fmt::print(stderr, "penumbra: cannot write `{}`: there is no folder `{}`\n", path.string(), folder.string());
        return EX_CANTCREAT;
      }
    }
  }
  if (number > 1 && !options.video.empty()) {
    fmt::print(stderr, "penumbra: a video needs one picture per frame, and this scene has {}\n", number);
    return EX_USAGE;
  }
  return 0;
}

}  // namespace penumbra
