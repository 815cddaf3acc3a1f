#include "app/render_command.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/stats.hpp"
#include "base/atomic_file.hpp"
#include "image/image_file.hpp"
#include "language/scene_file.hpp"
#include "picture/develop.hpp"
#include "picture/metadata.hpp"
#include "picture/ray_tree_text.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/isa.hpp"
#include "rendering/render.hpp"

namespace penumbra {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_usage = 64;
constexpr int exit_scene = 65;
constexpr int exit_no_input = 66;
constexpr int exit_software = 70;
constexpr int exit_cannot_create = 73;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Of all threads since the program started. Where others use the processor too, this says more than time by the clock.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

class RenderRun {
 public:
  explicit RenderRun(const RenderOptions& options) : options_(options) {}

  int run() {
    if (usable_kernels().empty()) {
      fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
      return exit_software;
    }
    const Clock::time_point start = Clock::now();
    const SceneFile file = read_scene(options_.scene, {options_.course, options_.lenient});
    stats_.parse_seconds = seconds_since(start);
    for (const Diagnostic& diagnostic : file.diagnostics) {
      if (!options_.quiet || diagnostic.severity == Severity::error) fmt::print(stderr, "{}", to_string(diagnostic));
    }
    if (has_error(file.diagnostics)) return exit_scene;

    const auto files = output_files(file.actions, options_.scene, options_.outputs);
    if (const int code = check_before_rendering(file.actions, files)) return code;
    std::size_t picture_number = 0;
    Clock::time_point timer = start;
    for (const Action& action : file.actions) {
      if (std::holds_alternative<ResetTimer>(action)) {
        timer = Clock::now();
      } else if (std::holds_alternative<PrintTimer>(action)) {
        fmt::print("seconds: {:.3f}\n", seconds_since(timer));
        std::fflush(stdout);
      } else {
        render_picture(std::get<Picture>(action), files[picture_number++]);
      }
    }
    if (!options_.stats.empty()) write_file_atomically(options_.stats, bytes_of(to_json(stats_)));
    return 0;
  }

 private:
  // What would make the work of rendering useless is found before it starts.
  int check_before_rendering(const std::vector<Action>& actions,
                             const std::vector<std::vector<std::filesystem::path>>& files) const {
    std::size_t number = 0;
    for (const Action& action : actions) {
      const auto* picture = std::get_if<Picture>(&action);
      if (!picture) continue;
      const Scene scene = with_options(*picture->scene, options_);
      if (const std::string missing = missing_number(scene, options_); !missing.empty()) {
        fmt::print(stderr, "penumbra: {}\n", missing);
        return exit_usage;
      }
      if (options_.crop && (options_.crop->x1 > scene.width || options_.crop->y1 > scene.height)) {
        fmt::print(stderr, "penumbra: --crop goes beyond the picture, which has {}x{} pixels\n", scene.width,
                   scene.height);
        return exit_usage;
      }
      if (const auto& debug = options_.debug_pixel;
          debug && (debug->x >= scene.width || debug->y >= scene.height || debug->sample >= scene.rays_per_pixel)) {
        fmt::print(stderr,
                   "penumbra: --debug-pixel is not in the picture, which has {}x{} pixels with {} samples each\n",
                   scene.width, scene.height, scene.rays_per_pixel);
        return exit_usage;
      }
      if (const Pattern pattern = pattern_for(scene, options_); options_.noise && needs_count(pattern)) {
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
    return 0;
  }

  void render_picture(const Picture& picture, const std::vector<std::filesystem::path>& files) {
    const Scene scene = with_options(*picture.scene, options_);
    const TracingOptions tracing = tracing_options(scene, options_);
    Plan plan;
    plan.crop = options_.crop.value_or(Crop{0, 0, scene.width, scene.height});
    plan.layers = options_.layers;
    plan.threads = options_.threads > 0 ? options_.threads : default_thread_count();

    Clock::time_point start = Clock::now();
    const Frame frame = make_frame(scene, tracing, plan.threads);
    stats_.build_seconds += seconds_since(start);
    const Kernel& kernel = options_.kernel ? *options_.kernel : *usable_kernels().back();
    const auto most_rays = static_cast<std::uint32_t>(scene.rays_per_pixel);
    if (options_.debug_pixel) return print_rays(frame, kernel, *options_.debug_pixel, most_rays);

    start = Clock::now();
    const double cpu_start = cpu_seconds();
    Film film(plan.crop, plan.layers, options_.noise ? SampleCounts::per_pixel : SampleCounts::uniform);
    RenderState state;
    AdaptiveResult result;
    const auto pixels = static_cast<std::uint64_t>(plan.crop.width()) * static_cast<std::uint64_t>(plan.crop.height());
    {
      const Progress progress(options_.quiet ? ProgressStyle::none : options_.progress, state, pixels * most_rays);
      if (options_.noise) {
        const NoiseGoal goal{static_cast<float>(*options_.noise), most_rays};
        result = render_adaptive(film, frame, kernel, plan, goal, state);
      } else {
        result.rays = render_samples(film, frame, kernel, plan, {0, most_rays}, state);
      }
    }
    const RayCounts& rays = result.rays;
    stats_.samples += rays.camera;
    const double render_seconds = seconds_since(start);
    stats_.render_seconds += render_seconds;
    stats_.render_cpu_seconds += cpu_seconds() - cpu_start;
    if (result.unfinished_pixels > 0 && !options_.quiet) {
      fmt::print(stderr, "penumbra: {} of {} pixels got the most rays, {}, and still have more noise than {}\n",
                 result.unfinished_pixels, pixels, most_rays, *options_.noise);
    }
    const std::string rays_per_pixel =
        options_.noise ? fmt::format("{:.1f} rays per pixel on average",
                                     static_cast<double>(film.total_samples()) / static_cast<double>(pixels))
                       : fmt::format("{} rays per pixel", most_rays);

    start = Clock::now();
    const ImageFile image =
        develop(film, scene.width, scene.height, picture.rects, exposure_factor(options_.exposure_halves),
                metadata_for(options_.scene, scene, options_));
    const Quantization quantization{options_.bits, options_.course ? Rounding::course : Rounding::nearest};
    for (const std::filesystem::path& path : files) {
      write_image(path, image, quantization);
      if (!options_.quiet) {
        const double rate = static_cast<double>(rays.total()) / std::max(render_seconds, 1e-9);
        fmt::print(stderr, "{}: {}x{} pixels, {}, {}, {:.1f} Mrays/s\n", path.string(), plan.crop.width(),
                   plan.crop.height(), rays_per_pixel, duration_text(render_seconds), rate * 1e-6);
      }
    }
    stats_.write_seconds += seconds_since(start);
    note(frame, kernel, plan, rays);
  }

  static void print_rays(const Frame& frame, const Kernel& kernel, const DebugPixel& pixel, std::uint32_t count) {
    const auto sample = static_cast<std::uint32_t>(pixel.sample);
    const RayTree tree = trace_sample(frame, kernel, pixel.x, pixel.y, sample, count);
    fmt::print("{}", ray_tree_text(frame, tree, pixel.x, pixel.y, sample));
  }

  void note(const Frame& frame, const Kernel& kernel, const Plan& plan, const RayCounts& rays) {
    stats_.rays += rays;
    stats_.threads = plan.threads;
    stats_.lanes = kernel.lanes;
    stats_.isa = kernel.isa;
    stats_.sampler = pattern_names[static_cast<int>(frame.options.pattern)];
    stats_.seed = frame.options.seed;
    stats_.noise = options_.noise;
    stats_.width = frame.width;
    stats_.height = frame.height;
    stats_.shapes = frame.world.shape_count;
    stats_.triangles = frame.world.triangle_count;
    stats_.instances = frame.world.instance_count;
    stats_.lights = frame.lights.size();
  }

  const RenderOptions& options_;
  RenderStats stats_;
};

}  // namespace

int render_command(const RenderOptions& options) {
  std::error_code error;
  if (!std::filesystem::exists(options.scene, error)) {
    fmt::print(stderr, "penumbra: there is no scene file `{}`\n", options.scene);
    return exit_no_input;
  }
  try {
    return RenderRun(options).run();
  } catch (const FileError& e) {
    fmt::print(stderr, "penumbra: {}\n", e.what());
    return e.exit_code;
  }
}

}  // namespace penumbra
