#include "app/render/render_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "app/files/rescue.hpp"
#include "app/render/memory_need.hpp"
#include "app/render/outputs.hpp"
#include "app/render/picture_files.hpp"
#include "app/render/picture_job.hpp"
#include "app/render/progress.hpp"
#include "app/render/render_paths.hpp"
#include "app/render/scene_frames.hpp"
#include "app/render/stats.hpp"
#include "app/render/video.hpp"
#include "app/sessions/render_session.hpp"
#include "base/atomic_file.hpp"
#include "base/say.hpp"
#include "base/version.hpp"
#include "rendering/ray_tree.hpp"
#include "rendering/small_objects.hpp"

namespace penumbra {
namespace {

using Clock = std::chrono::steady_clock;
using Files = std::vector<std::filesystem::path>;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The CPU time of all threads since the program started; on a shared machine it says more than wall-clock time.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

// Whether the hash has to show later that a checkpoint, a part or a finished frame is of the same scene files.
bool needs_hash(const RenderOptions& options) {
  return !options.session.checkpoint.empty() || options.session.shard || options.frames;
}

std::string frames_in_words(const PictureOptions& options) {
  return options.frames ? fmt::format("{}-{}", options.frames->first, options.frames->last) : not_given;
}

// Renders all pictures of a command, frame by frame.
class RenderRun {
 public:
  RenderRun(const RenderOptions& options, const Kernel& kernel)
      : asked_(options),
        kernel_(kernel),
        session_(options.session, start_, options.quiet),
        scenes_(options, needs_hash(options)) {}

  int run() {
    RenderPaths paths(asked_);
    const std::filesystem::path ffmpeg = asked_.video.empty() ? std::filesystem::path() : find_ffmpeg();
    if (const int code = check_everything(paths)) return code;
    bool finished = true;
    for (const std::optional<int>& frame : scenes_.frames()) {
      scenes_.go_to(frame);
      finished = render_file();
      if (!finished || failure_ != 0) break;
      scenes_.current_is_done();
    }
    const bool all_is_done = finished && failure_ == 0;
    if (failure_ == 0) failure_ = session_.failure();
    stats_.parse_seconds = scenes_.seconds();
    if (!asked_.stats.empty()) write_or_rescue(asked_.stats, bytes_of(to_json(stats_)));
    if (!finished) complain(session_.why());
    if (all_is_done) session_.finish();
    if (all_is_done && !asked_.video.empty()) {
      write_video(asked_.video, first_files_, asked_.frames_per_second.value_or(usual_frames_per_second), ffmpeg);
      if (!asked_.quiet) say(fmt::format("{}: {} frames\n", asked_.video, first_files_.size()));
    }
    return failure_ != 0 ? failure_ : finished ? EX_OK : EX_TEMPFAIL;
  }

 private:
  // Everything that can be known before the first ray. Returns the exit code, 0 if nothing is wrong. Throws FileError.
  int check_everything(RenderPaths& paths) {
    MemoryNeed need;
    const auto visit = [&] {
      paths.add(scenes_);
      const MemoryNeed of_frame = memory_need(scenes_.options(), scenes_.file());
      if (of_frame.bytes > need.bytes) need = of_frame;
    };
    if (const int code = scenes_.check(visit)) return code;
    if (!asked_.debug_pixel) require_memory(need, asked_.memory_limit);
    paths.try_to_write();
    session_.open_checkpoint();
    session_.require_scene(version, scenes_.file().hash, frames_in_words(scenes_.options()));
    return EX_OK;
  }

  // Carries out the actions of the scene in their order, up to a file that cannot be written. Returns false if
  // interrupted.
  bool render_file() {
    int number = 0;
    Clock::time_point timer = start_;
    const auto outputs = scenes_.outputs();
    for (const Action& action : scenes_.file().actions) {
      if (std::holds_alternative<ResetTimer>(action)) {
        timer = Clock::now();
      } else if (std::holds_alternative<PrintTimer>(action)) {
        const auto tell = has_standard_output(asked_.outputs) ? say : print;
        tell(fmt::format("seconds: {:.3f}\n", seconds_since(timer)));
      } else {
        const Files& files = outputs[static_cast<std::size_t>(number++)];
        const PictureJob job = picture_job(scenes_.options(), scenes_.file(), std::get<Picture>(action), number);
        if (!asked_.video.empty()) first_files_.push_back(files.front());
        if (is_finished(job, files)) continue;
        if (asked_.frames && session_.is_over()) return false;
        if (!render_picture(job, files)) return false;
        if (failure_ != 0) break;
      }
    }
    return true;
  }

  // Whether an earlier run has finished the picture; for a frame, judging by its files.
  bool is_finished(const PictureJob& job, const Files& files) const {
    const auto exists = [](const auto& file) {
      std::error_code error;
      return std::filesystem::exists(file, error);
    };
    if (!asked_.frames) {
      return session_.has_finished(job.key) && std::all_of(files.begin(), files.end(), exists);
    }
    if (!asked_.session.resume) return false;
    const bool is_part = asked_.session.shard.has_value();
    const bool finished =
        std::all_of(files.begin(), files.end(), [&](const auto& file) { return is_finished_file(file, job, is_part); });
    if (!asked_.quiet && (finished || exists(files.front()))) {
      say(fmt::format(
          "{}: {}\n", files.front().string(),
          finished ? "already finished" : "not the finished frame of this scene and these options: rendering it"));
    }
    return finished;
  }

  // Returns false if interrupted: the files then show the picture as it stands.
  bool render_picture(const PictureJob& job, const Files& files) {
    session_.prepare();
    Clock::time_point start = Clock::now();
    const Frame frame = make_frame(job.scene, job.plan.threads);
    stats_.build_seconds += seconds_since(start);
    if (asked_.debug_pixel) {
      print_rays(frame, *asked_.debug_pixel);
      return true;
    }

    std::unique_ptr<ResumableRender> render = render_of(job, scenes_.options(), frame, kernel_);
    const std::uint64_t pixels = pixel_count(tiles_of(job.plan.crop, asked_.sample_counts()), job.plan.shard);
    if (asked_.noise && !asked_.quiet) warn_of_small_objects(job, frame);
    RenderState state;
    bool finished = false;
    {
      const std::uint64_t samples = pixels * static_cast<std::uint64_t>(frame.settings.rays_per_pixel);
      const Progress progress(asked_.quiet ? ProgressStyle::none : asked_.progress, state, samples);
      const double cpu_start = cpu_seconds();
      finished = session_.run(*render, job.key, state);
      stats_.render_cpu_seconds += cpu_seconds() - cpu_start;
    }
    add_to_stats(frame, job.plan);
    if (render->unfinished_pixels() > 0 && !asked_.quiet) {
      complain(fmt::format("{} of {} pixels got the maximum of {} rays and still have more noise than {}",
                           render->unfinished_pixels(), pixels, frame.settings.rays_per_pixel, *asked_.noise));
    }

    if (const NotFiniteSamples& wrong = session_.spent().rays.not_finite; wrong.count > 0 && !asked_.quiet) {
      warn(
          fmt::format("{} of {} samples {} not finite and {} shown as the largest value, {:.6g}; the same "
                      "command with --debug-pixel {},{},{} shows the rays of the first",
                      wrong.count, session_.spent().rays[RayKind::eye], wrong.count == 1 ? "is" : "are",
                      wrong.count == 1 ? "is" : "are", frame.largest_color, wrong.x, wrong.y, wrong.sample));
    }

    start = Clock::now();
    Film film = render->take_film();
    render.reset();
    write(job, std::move(film), finished, files, static_cast<double>(pixels));
    stats_.write_seconds += seconds_since(start);
    return finished;
  }

  void warn_of_small_objects(const PictureJob& job, const Frame& frame) const {
    const std::uint32_t first = 1u << AdaptiveRules(goal_of(scenes_.options(), frame.settings), frame).first_level;
    const SmallObjects small = small_objects(job.scene, *asked_.noise, first);
    if (small.count == 0) return;
    warn(
        fmt::format("the first {} rays of each pixel may miss {} small object{}, and --noise then sends "
                    "no more there: --first-rays {} finds {}",
                    first, small.count, small.count == 1 ? "" : "s", small.rays, small.count == 1 ? "it" : "them"));
  }

  void write(const PictureJob& job, Film film, bool finished, const Files& files, double pixels) {
    const double rays_per_pixel = static_cast<double>(film.total_samples()) / pixels;
    encode_files(job, std::move(film), finished, asked_.session.shard.has_value(), files,
                 [&](const std::filesystem::path& path, std::span<const std::byte> bytes) {
                   if (!write_or_rescue(path, bytes)) return;
                   if (!asked_.quiet) print_written(path, job.plan, rays_per_pixel);
                 });
  }

  // Returns whether the file could be written in its own place. If not, says where else it is.
  bool write_or_rescue(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    try {
      write_file_atomically(path, bytes);
    } catch (const FileError& error) {
      const std::optional<std::filesystem::path> other = rescue(path, bytes);
      complain(other ? fmt::format("{}; it is in `{}` instead", error.what(), other->string()) : error.what());
      failure_ = error.exit_code;
      return false;
    }
    // The checkpoint is removed next: a power cut must not lose the file but keep the removal.
    if (!asked_.session.checkpoint.empty()) force_folder_of(path);
    return true;
  }

  void print_written(const std::filesystem::path& path, const Plan& plan, double rays_per_pixel) const {
    const Spent& spent = session_.spent();
    const std::string rays = asked_.noise ? fmt::format("{:.1f} rays per pixel on average", rays_per_pixel)
                                          : fmt::format("{} rays per pixel", std::round(10 * rays_per_pixel) / 10);
    say(fmt::format("{}: {}x{} pixels, {}, {}, {:.1f} Mrays/s\n", path.string(), plan.crop.width(), plan.crop.height(),
                    rays, duration_text(spent.seconds),
                    static_cast<double>(spent.rays.total()) / std::max(spent.seconds, 1e-9) * 1e-6));
  }

  void print_rays(const Frame& frame, const DebugPixel& pixel) const {
    const auto sample = static_cast<std::uint32_t>(pixel.sample);
    const auto count = static_cast<std::uint32_t>(frame.settings.rays_per_pixel);
    const RayTree tree = trace_sample(frame, kernel_, pixel.x, pixel.y, sample, count);
    print(ray_tree_text(frame, tree, pixel.x, pixel.y, sample));
  }

  void add_to_stats(const Frame& frame, const Plan& plan) {
    const Spent& spent = session_.spent();
    stats_.rays += spent.rays;
    stats_.samples += spent.rays[RayKind::eye];
    stats_.render_seconds += spent.seconds;
    stats_.threads = plan.threads;
    stats_.lanes = kernel_.lanes;
    stats_.isa = kernel_.isa;
    stats_.settings = frame.settings;
    stats_.noise = asked_.noise;
    stats_.shapes = frame.world.counts.shapes;
    stats_.triangles = frame.world.counts.triangles;
    stats_.instances = frame.world.counts.instances;
    stats_.lights = frame.lights.size();
  }

  const Clock::time_point start_ = Clock::now();
  const RenderOptions& asked_;
  const Kernel& kernel_;
  RenderSession session_;
  SceneFrames scenes_;
  Files first_files_;  // of each frame, for the video
  RenderStats stats_;
  int failure_ = 0;  // the exit code of a file that could not be written
};

}  // namespace

int render_command(const RenderOptions& options) {
  std::error_code error;
  if (options.scene != standard_input && !std::filesystem::exists(options.scene, error)) {
    complain(fmt::format("there is no scene file `{}`", options.scene));
    return EX_NOINPUT;
  }
  const Kernel* const kernel = kernel_of(options.machine);
  if (!kernel) return EX_SOFTWARE;
  try {
    return RenderRun(options, *kernel).run();
  } catch (const FileError& e) {
    complain(e.what());
    return e.exit_code;
  }
}

}  // namespace penumbra
