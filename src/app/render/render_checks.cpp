#include "app/render/render_checks.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include "base/say.hpp"
#include "image/image_file.hpp"
#include "language/path_boundary.hpp"

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
      complain(missing);
      return EX_USAGE;
    }
    if (options.crop && (options.crop->x1 > settings.width || options.crop->y1 > settings.height)) {
      complain(fmt::format("--crop goes beyond the picture, which has {}x{} pixels", settings.width, settings.height));
      return EX_USAGE;
    }
    if (const auto& debug = options.debug_pixel; debug && (debug->x >= settings.width || debug->y >= settings.height ||
                                                           debug->sample >= settings.rays_per_pixel)) {
      complain(fmt::format("--debug-pixel is not in the picture, which has {}x{} pixels with {} samples each",
                           settings.width, settings.height, settings.rays_per_pixel));
      return EX_USAGE;
    }
    if (const Pattern pattern = settings.pattern; options.noise && needs_count(pattern)) {
      complain(
          fmt::format("--noise needs a sample pattern that can be extended, and `{}` has a fixed number of rays; "
                      "use --sampler {}",
                      pattern_names[static_cast<int>(pattern)], pattern_names[static_cast<int>(default_pattern)]));
      return EX_USAGE;
    }
    for (const std::filesystem::path& path : files[number++]) {
      if (format_of(path) == ImageFormat::none) {
        complain(
            fmt::format("cannot write `{}`: the name ends neither in .png nor in .exr; name another "
                        "file with -o",
                        path.string()));
        return EX_CANTCREAT;
      }
      if (options.outputs.empty() && !options.allow_paths && !is_in_reach(path, options.scene)) {
        complain(
            fmt::format("cannot write `{}`: it is a link to a file outside the working folder and the folder of "
                        "the scene; name another file with -o, or allow it with --allow-paths",
                        path.string()));
        return EX_CANTCREAT;
      }
      const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
      if (!std::filesystem::is_directory(folder)) {
        complain(fmt::format("cannot write `{}`: there is no folder `{}`", path.string(), folder.string()));
        return EX_CANTCREAT;
      }
    }
  }
  if (number > 1 && !options.video.empty()) {
    complain(fmt::format("a video needs one picture per frame, and this scene has {}", number));
    return EX_USAGE;
  }
  return 0;
}

}  // namespace penumbra
