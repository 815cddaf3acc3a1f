#include "app/render_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>

#include "app/finished_files.hpp"
#include "app/outputs.hpp"
#include "app/part_file.hpp"
#include "app/progress.hpp"
#include "app/render_checks.hpp"
#include "app/sitting.hpp"
#include "app/stats.hpp"
#include "app/video.hpp"
#include "base/atomic_file.hpp"
#include "base/thread_count.hpp"
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

constexpr int exit_scene = 65;
constexpr int exit_no_input = 66;
constexpr int exit_software = 70;
constexpr int exit_interrupted = 75;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Of all threads since the program started. Where others use the processor too, this says more than time by the clock.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

// One picture of a scene file: what it is made of, and what that is called.
struct Job {
  Scene scene;
  Plan plan;
  Development development;
  PictureKey key;
};

class RenderRun {
 public:
  explicit RenderRun(const RenderOptions& options)
      : options_(options), start_(Clock::now()), sitting_(options.sitting, start_, options.quiet) {}

  int run() {
    if (usable_kernels().empty()) {
      fmt::print(stderr, "penumbra: this machine has none of the instruction sets that this program was built for\n");
      return exit_software;
    }
    const std::vector<std::optional<FrameOfRange>> frames = frames_to_render(options_.frames);
    const std::string& video = options_.frames.video;
    const std::filesystem::path ffmpeg = video.empty() ? std::filesystem::path() : find_ffmpeg();
    if (const int code = check(frames)) return code;
    bool finished = true;
    for (std::size_t i = 0; i < frames.size() && finished; i++) {
      read(frames[i]);
      if (i == 0) sitting_.require_scene(version, file_.hash, frames_in_words());
      finished = render_file();
    }
    if (!options_.stats.empty()) write_output(options_.stats, bytes_of(to_json(stats_)));
    if (!finished) {
      fmt::print(stderr, "penumbra: {}\n", sitting_.why());
      return exit_interrupted;
    }
    sitting_.finish();
    if (!video.empty()) {
      write_video(video, first_files_, options_.frames.frames_per_second, ffmpeg);
      if (!options_.quiet) fmt::print(stderr, "{}: {} frames\n", video, first_files_.size());
    }
    return 0;
  }

 private:
  // Reads the scene as it is at that frame, unless it is there already.
  void read(const std::optional<FrameOfRange>& frame) {
    options_.frame = frame;
    if (is_read_ && (!file_.varies || frame == read_frame_)) return;
    ReadOptions read_options{.course = options_.course, .lenient = options_.lenient};
    const SittingOptions& sitting = options_.sitting;
    read_options.hash = !sitting.checkpoint.empty() || sitting.shard || frame || !sitting.scene_hash.empty();
    if (frame) read_options.moment = {static_cast<double>(frame->frame), frame->time_at(0)};
    const Clock::time_point start = Clock::now();
    file_ = read_scene(options_.scene, read_options);
    stats_.parse_seconds += seconds_since(start);
    is_read_ = true;
    read_frame_ = frame;
  }

  // Goes through all frames and tells what would make the work of rendering useless. Returns the exit code, 0 if there
  // is nothing.
  int check(const std::vector<std::optional<FrameOfRange>>& frames) {
    for (std::size_t i = 0; i < frames.size(); i++) {
      read(frames[i]);
      const bool wrong = has_error(file_.diagnostics);
      if (wrong && file_.varies && frames[i]) fmt::print(stderr, "penumbra: in frame {}:\n", frames[i]->frame);
      for (const Diagnostic& diagnostic : file_.diagnostics) {
        const bool is_new = i == 0 && !options_.quiet;
        if (is_new || diagnostic.severity == Severity::error) fmt::print(stderr, "{}", to_string(diagnostic));
      }
      if (wrong) return exit_scene;
      require_hash();
      if (const int code = check_before_rendering(options_, file_.actions, files())) return code;
      if (!file_.varies) break;
    }
    return 0;
  }

  // The files of each picture of the scene that is read.
  std::vector<std::vector<std::filesystem::path>> files() const {
    auto files = output_files(file_.actions, options_.scene, options_.outputs);
    if (!options_.frame) return files;
    for (auto& of_picture : files) {
      for (std::filesystem::path& file : of_picture) file = with_frame_number(file, *options_.frame);
    }
    return files;
  }

  std::string frames_in_words() const {
    if (!options_.frame) return not_given;
    return fmt::format("{}-{}", options_.frame->first, options_.frame->last);
  }

  // Does what the scene says, in its order. False if it was interrupted.
  bool render_file() {
    int number = 0;
    Clock::time_point timer = start_;
    const auto names = files();
    for (const Action& action : file_.actions) {
      if (std::holds_alternative<ResetTimer>(action)) {
        timer = Clock::now();
      } else if (std::holds_alternative<PrintTimer>(action)) {
        fmt::print("seconds: {:.3f}\n", seconds_since(timer));
        std::fflush(stdout);
      } else {
        const auto& of_picture = names[static_cast<std::size_t>(number++)];
        const Job job = job_for(std::get<Picture>(action), number);
        if (!options_.frames.video.empty()) first_files_.push_back(of_picture.front());
        if (is_finished(job, of_picture)) continue;
        if (options_.frame && sitting_.is_over()) return false;
        if (!render_picture(job, of_picture)) return false;
      }
    }
    return true;
  }

  void require_hash() const {
    const std::string& expected = options_.sitting.scene_hash;
    if (expected.empty() || to_hex(file_.hash) == expected) return;
    throw FileError(exit_scene, fmt::format("`{}`, or a file that it reads, has changed: the hash of its files is {}, "
                                            "and {} is asked for",
                                            options_.scene, to_hex(file_.hash), expected));
  }

  Job job_for(const Picture& picture, int number) const {
    Job job;
    job.scene = with_options(*picture.scene, options_);
    job.plan.crop = options_.crop.value_or(PixelRect{0, 0, job.scene.settings.width, job.scene.settings.height});
    job.plan.layers = options_.layers;
    job.plan.threads = options_.threads > 0 ? options_.threads : default_thread_count();
    job.plan.shard = options_.sitting.shard.value_or(Shard{});
    job.development = {job.scene.settings.width,
                       job.scene.settings.height,
                       picture.rects,
                       metadata_for(options_.scene, job.scene, options_),
                       options_.exposure_halves,
                       options_.bits,
                       options_.course ? Rounding::course : Rounding::nearest};
    job.key = {version, file_.hash, number, plan_in_words(job.development.metadata, job.plan.layers)};
    if (options_.frame) {
      job.development.metadata.emplace_back(content_entry, content_key(job.key, job.development));
    }
    return job;
  }

  // Whether an earlier run has finished the picture. Of a frame, its files tell it.
  bool is_finished(const Job& job, const std::vector<std::filesystem::path>& files) const {
    const auto exists = [](const auto& file) {
      std::error_code error;
      return std::filesystem::exists(file, error);
    };
    if (!options_.frame) {
      return sitting_.has_finished(job.key.picture) && std::all_of(files.begin(), files.end(), exists);
    }
    if (!options_.sitting.resume) return false;
    const bool finished = std::all_of(files.begin(), files.end(), [&](const std::filesystem::path& file) {
      return options_.sitting.shard ? is_finished_part(file, job.key, job.plan.shard, job.development)
                                    : is_finished_picture(file, job.development.metadata.back().second);
    });
    if (!options_.quiet && (finished || exists(files.front()))) {
      fmt::print(
          stderr, "{}: {}\n", files.front().string(),
          finished ? "finished before" : "not the finished frame of this scene and these options: it is rendered");
    }
    return finished;
  }

  std::unique_ptr<ResumableRender> render_for(const Frame& frame, const Kernel& kernel, const Plan& plan) const {
    const auto rays = static_cast<std::uint32_t>(frame.settings.rays_per_pixel);
    if (!options_.noise) {
      const bool in_passes = options_.sitting.has_end_in_mind() && !options_.sitting.shard;
      return std::make_unique<UniformRender>(frame, kernel, plan, rays, in_passes);
    }
    return std::make_unique<AdaptiveRender>(frame, kernel, plan, NoiseGoal{static_cast<float>(*options_.noise), rays});
  }

  // False if it was interrupted: the files then show the picture as it stands.
  bool render_picture(const Job& job, const std::vector<std::filesystem::path>& files) {
    const Plan& plan = job.plan;
    Clock::time_point start = Clock::now();
    const Frame frame = make_frame(job.scene, plan.threads);
    stats_.build_seconds += seconds_since(start);
    const Kernel& kernel = options_.kernel ? *options_.kernel : *usable_kernels().back();
    if (options_.debug_pixel) {
      print_rays(frame, kernel, *options_.debug_pixel);
      return true;
    }

    const std::unique_ptr<ResumableRender> render = render_for(frame, kernel, plan);
    const std::uint64_t pixels = pixel_count(tiles_of(plan.crop, options_.sample_counts()), plan.shard);
    RenderState state;
    bool finished = false;
    {
      const std::uint64_t samples = pixels * static_cast<std::uint64_t>(job.scene.settings.rays_per_pixel);
      const Progress progress(options_.quiet ? ProgressStyle::none : options_.progress, state, samples);
      const double cpu_start = cpu_seconds();
      finished = sitting_.run(*render, job.key, state);
      stats_.render_cpu_seconds += cpu_seconds() - cpu_start;
    }
    note(frame, kernel, plan);
    if (render->unfinished_pixels() > 0 && !options_.quiet) {
      fmt::print(stderr, "penumbra: {} of {} pixels got the most rays, {}, and still have more noise than {}\n",
                 render->unfinished_pixels(), pixels, job.scene.settings.rays_per_pixel, *options_.noise);
    }

    start = Clock::now();
    write(job, render->take_film(), finished, files, static_cast<double>(pixels));
    stats_.write_seconds += seconds_since(start);
    return finished;
  }

  void write(const Job& job, Film film, bool finished, const std::vector<std::filesystem::path>& files,
             double pixels) const {
    const double rays_per_pixel = static_cast<double>(film.total_samples()) / pixels;
    const auto write_one = [&](const std::filesystem::path& path, std::span<const std::byte> bytes) {
      write_output(path, bytes);
      if (!options_.quiet) tell(path, job.plan, rays_per_pixel);
    };
    Development development = job.development;
    if (!options_.sitting.shard) {
      if (!finished && options_.frame) development.metadata.pop_back();  // its content is another
      const ImageFile image = develop(std::move(film), development);
      const Quantization quantization{development.bits, development.rounding};
      for (const auto& path : files) write_one(path, encode_image(image, format_of(path), quantization));
    } else if (finished) {  // half a part is of no use to anyone: the checkpoint has what there is
      const PartHeader header{job.key,         job.plan.shard, job.plan.crop,
                              job.plan.layers, film.counts(),  to_bytes(development)};
      write_one(files.front(), encode_part_file(header, film));
    }
  }

  void write_output(const std::filesystem::path& path, std::span<const std::byte> bytes) const {
    write_file_atomically(path, bytes);
    // The checkpoint is removed next; a power cut must not keep that and lose the file.
    if (!options_.sitting.checkpoint.empty()) force_folder_of(path);
  }

  void tell(const std::filesystem::path& path, const Plan& plan, double rays_per_pixel) const {
    const Spent& spent = sitting_.spent();
    const std::string rays = options_.noise ? fmt::format("{:.1f} rays per pixel on average", rays_per_pixel)
                                            : fmt::format("{} rays per pixel", std::round(10 * rays_per_pixel) / 10);
    fmt::print(stderr, "{}: {}x{} pixels, {}, {}, {:.1f} Mrays/s\n", path.string(), plan.crop.width(),
               plan.crop.height(), rays, duration_text(spent.seconds),
               static_cast<double>(spent.rays.total()) / std::max(spent.seconds, 1e-9) * 1e-6);
  }

  static void print_rays(const Frame& frame, const Kernel& kernel, const DebugPixel& pixel) {
    const auto sample = static_cast<std::uint32_t>(pixel.sample);
    const auto count = static_cast<std::uint32_t>(frame.settings.rays_per_pixel);
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
    stats_.sampler = pattern_names[static_cast<int>(frame.settings.pattern)];
    stats_.seed = frame.settings.seed;
    stats_.noise = options_.noise;
    stats_.width = frame.settings.width;
    stats_.height = frame.settings.height;
    stats_.shapes = frame.world.shape_count;
    stats_.triangles = frame.world.triangle_count;
    stats_.instances = frame.world.instance_count;
    stats_.lights = frame.lights.size();
  }

  RenderOptions options_;  // of the frame that is read
  const Clock::time_point start_;
  Sitting sitting_;
  SceneFile file_;
  bool is_read_ = false;
  std::optional<FrameOfRange> read_frame_;
  std::vector<std::filesystem::path> first_files_;  // of each frame, for the video
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
