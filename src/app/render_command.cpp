#include "app/render_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/outputs.hpp"
#include "app/part_file.hpp"
#include "app/progress.hpp"
#include "app/sitting.hpp"
#include "app/stats.hpp"
#include "base/atomic_file.hpp"
#include "base/version.hpp"
#include "image/image_file.hpp"
#include "language/scene_file.hpp"
#include "picture/develop.hpp"
#include "picture/metadata.hpp"
#include "picture/plan_in_words.hpp"
#include "picture/ray_tree_text.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/isa.hpp"
#include "rendering/render.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_usage = 64;
constexpr int exit_scene = 65;
constexpr int exit_no_input = 66;
constexpr int exit_software = 70;
constexpr int exit_cannot_create = 73;
constexpr int exit_interrupted = 75;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

class RenderRun {
 public:
  explicit RenderRun(const RenderOptions& options)
      : options_(options), start_(Clock::now()), sitting_(options.sitting, start_, options.quiet) {}

  int run() {
    if (usable_kernels().empty()) {
      fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
      return exit_software;
    }
    const SittingOptions& sitting = options_.sitting;
    const bool wants_hash = !sitting.checkpoint.empty() || sitting.shard || !sitting.scene_hash.empty();
    const SceneFile file = read_scene(options_.scene, {options_.course, options_.lenient, wants_hash});
    stats_.parse_seconds = seconds_since(start_);
    for (const Diagnostic& diagnostic : file.diagnostics) {
      if (!options_.quiet || diagnostic.severity == Severity::error) fmt::print(stderr, "{}", to_string(diagnostic));
    }
    if (has_error(file.diagnostics)) return exit_scene;

    require_hash(file.hash);
    const auto files = output_files(file.actions, options_.scene, options_.outputs);
    if (const int code = check_before_rendering(file.actions, files)) return code;
    sitting_.require_scene(version, file.hash);
    int exit_code = 0;
    std::size_t picture_number = 0;
    Clock::time_point timer = start_;
    for (const Action& action : file.actions) {
      if (std::holds_alternative<ResetTimer>(action)) {
        timer = Clock::now();
      } else if (std::holds_alternative<PrintTimer>(action)) {
        fmt::print("seconds: {:.3f}\n", seconds_since(timer));
        std::fflush(stdout);
      } else {
        const auto& names = files[picture_number++];
        const auto number = static_cast<int>(picture_number);
        if (sitting_.has_finished(number) && are_there(names)) continue;
        if (!render_picture(std::get<Picture>(action), file.hash, number, names)) {
          fmt::print(stderr, "penumbra: {}\n", sitting_.why());
          exit_code = exit_interrupted;
          break;
        }
      }
    }
    if (!options_.stats.empty()) write_file_atomically(options_.stats, bytes_of(to_json(stats_)));
    if (exit_code == 0) sitting_.finish();
    return exit_code;
  }

 private:
  void require_hash(const ContentHash& hash) const {
    const std::string& expected = options_.sitting.scene_hash;
    if (expected.empty() || to_hex(hash) == expected) return;
    throw FileError(exit_scene, fmt::format("`{}`, or a file that it reads, has changed: the hash of its files is {}, "
                                            "and {} is asked for",
                                            options_.scene, to_hex(hash), expected));
  }

  static bool are_there(const std::vector<std::filesystem::path>& files) {
    return std::all_of(files.begin(), files.end(), [](const auto& file) {
      std::error_code error;
      return std::filesystem::exists(file, error);
    });
  }

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

  std::unique_ptr<ResumableRender> render_for(const Frame& frame, const Kernel& kernel, const Plan& plan) const {
    const auto rays = static_cast<std::uint32_t>(frame.options.rays_per_pixel);
    if (!options_.noise) {
      const bool in_passes = options_.sitting.has_end_in_mind() && !options_.sitting.shard;
      return std::make_unique<UniformRender>(frame, kernel, plan, rays, in_passes);
    }
    return std::make_unique<AdaptiveRender>(frame, kernel, plan, NoiseGoal{static_cast<float>(*options_.noise), rays});
  }

  // False if it was interrupted: the files then show the picture as it stands.
  bool render_picture(const Picture& picture, const ContentHash& scene_hash, int number,
                      const std::vector<std::filesystem::path>& files) {
    const Scene scene = with_options(*picture.scene, options_);
    const TracingOptions tracing = tracing_options(scene, options_);
    Plan plan;
    plan.crop = options_.crop.value_or(Crop{0, 0, scene.width, scene.height});
    plan.layers = options_.layers;
    plan.threads = options_.threads > 0 ? options_.threads : default_thread_count();
    plan.shard = options_.sitting.shard.value_or(Shard{});
    const Development development{scene.width,
                                  scene.height,
                                  picture.rects,
                                  metadata_for(options_.scene, scene, options_),
                                  options_.exposure_halves,
                                  options_.bits,
                                  options_.course ? Rounding::course : Rounding::nearest};
    const PictureKey key{version, scene_hash, number, plan_in_words(development.metadata, plan.layers)};

    Clock::time_point start = Clock::now();
    const Frame frame = make_frame(scene, tracing, plan.threads);
    stats_.build_seconds += seconds_since(start);
    const Kernel& kernel = options_.kernel ? *options_.kernel : *usable_kernels().back();
    if (options_.debug_pixel) {
      print_rays(frame, kernel, *options_.debug_pixel);
      return true;
    }

    const std::unique_ptr<ResumableRender> render = render_for(frame, kernel, plan);
    const std::uint64_t pixels = pixel_count(plan.crop, plan.shard);
    RenderState state;
    bool finished = false;
    {
      const std::uint64_t samples = pixels * static_cast<std::uint64_t>(scene.rays_per_pixel);
      const Progress progress(options_.quiet ? ProgressStyle::none : options_.progress, state, samples);
      finished = sitting_.run(*render, key, state);
    }
    note(frame, kernel, plan);
    if (render->unfinished_pixels() > 0 && !options_.quiet) {
      fmt::print(stderr, "penumbra: {} of {} pixels got the most rays, {}, and still have more noise than {}\n",
                 render->unfinished_pixels(), pixels, scene.rays_per_pixel, *options_.noise);
    }

    start = Clock::now();
    const Film film = render->take_film();
    const auto write = [&](const std::filesystem::path& path, std::span<const std::byte> bytes) {
      write_file_atomically(path, bytes);
      if (!options_.quiet) tell(path, plan, film, static_cast<double>(pixels));
    };
    if (!options_.sitting.shard) {
      const ImageFile image = develop(film, development);
      const Quantization quantization{development.bits, development.rounding};
      for (const auto& path : files) write(path, encode_image(image, format_of(path), quantization));
    } else if (finished) {  // half a part is of no use to anyone: the checkpoint has what there is
      const PartHeader header{key, plan.shard, plan.crop, plan.layers, film.counts(), to_bytes(development)};
      write(files.front(), encode_part_file(header, film));
    }
    stats_.write_seconds += seconds_since(start);
    return finished;
  }

  void tell(const std::filesystem::path& path, const Plan& plan, const Film& film, double pixels) const {
    const Spent& spent = sitting_.spent();
    const double rays_per_pixel = static_cast<double>(film.total_samples()) / pixels;
    const std::string rays = options_.noise ? fmt::format("{:.1f} rays per pixel on average", rays_per_pixel)
                                            : fmt::format("{} rays per pixel", std::round(10 * rays_per_pixel) / 10);
    fmt::print(stderr, "{}: {}x{} pixels, {}, {}, {:.1f} Mrays/s\n", path.string(), plan.crop.width(),
               plan.crop.height(), rays, duration_text(spent.seconds),
               static_cast<double>(spent.rays.total()) / std::max(spent.seconds, 1e-9) * 1e-6);
  }

  static void print_rays(const Frame& frame, const Kernel& kernel, const DebugPixel& pixel) {
    const auto sample = static_cast<std::uint32_t>(pixel.sample);
    const auto count = static_cast<std::uint32_t>(frame.options.rays_per_pixel);
    const RayTree tree = trace_sample(frame, kernel, pixel.x, pixel.y, sample, count);
    fmt::print("{}", ray_tree_text(frame, tree, pixel.x, pixel.y, sample));
  }

  void note(const Frame& frame, const Kernel& kernel, const Plan& plan) {
    const Spent& spent = sitting_.spent();
    stats_.rays += spent.rays;
    stats_.samples += spent.rays.camera;
    stats_.render_seconds += spent.seconds;
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
  const Clock::time_point start_;
  Sitting sitting_;
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
