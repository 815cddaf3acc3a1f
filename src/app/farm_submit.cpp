#include "app/farm_submit.hpp"

#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <numeric>

#include "app/frame_options.hpp"
#include "app/outputs.hpp"
#include "app/render_checks.hpp"
#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/version.hpp"
#include "farm/job.hpp"
#include "farm/shell_words.hpp"
#include "farm/slurm.hpp"
#include "farm/survey.hpp"
#include "language/scene_file.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

// Where Slurm does not say how many processors it has.
constexpr int usual_shards = 24;
constexpr int shards_for_each_task = 4;  // one that is lost or late is then a small matter
constexpr int tiles_worth_a_shard = 64;

// A name that no other job has, of letters that mean nothing to Slurm.
std::string name_of_job(const fs::path& output, const fs::path& folder) {
  std::string name = output.stem().string().substr(0, 24);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  const std::string origin =
      fmt::format("{} {} {}", folder.string(), ::getpid(), std::chrono::system_clock::now().time_since_epoch().count());
  return fmt::format("{}-{:08x}", name, checksum(std::as_bytes(std::span(origin)), 0) >> 32);
}

// Of the picture with the fewest.
int tile_count(const SceneFile& file, const RenderOptions& options) {
  int fewest = most_units;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    const auto [width, height] =
        options.size.value_or(std::pair(picture->scene->settings.width, picture->scene->settings.height));
    fewest = std::min(fewest,
                      tiles_of(options.crop.value_or(PixelRect{0, 0, width, height}), options.sample_counts()).count());
  }
  return fewest;
}

int good_number_of_shards(int frames, int tiles, const Job& job) {
  const std::optional<int> processors = processors_of(job.partition);
  const int units = processors ? shards_for_each_task * std::max(1, *processors / job.threads) : usual_shards;
  const int shards = (units + frames - 1) / frames;
  return std::clamp(shards, 1, std::max(1, std::min(tiles / tiles_worth_a_shard, most_tasks)));
}

// Nothing that anyone would miss is lost if a job is written here.
void require_free(const JobFolder& folder) {
  const std::string name = folder.path().string();
  std::error_code error;
  if (!fs::exists(folder.path(), error)) return;
  if (!fs::exists(folder.manifest(), error)) {
    if (fs::is_directory(folder.path(), error) && fs::is_empty(folder.path(), error)) return;
    throw FileError(EX_CANTCREAT, fmt::format("`{}` is no job folder; name another one with --folder", name));
  }
  if (folder.read_state().submitted || !fs::is_empty(folder.parts(), error)) {
    throw FileError(EX_CANTCREAT,
                    fmt::format("`{}` is the folder of a job that has begun: see `penumbra farm status`; remove the "
                                "folder to begin anew, or name another one with --folder",
                                name));
  }
}

// What the scene is at each frame, as far as a job has to know it.
struct Frames {
  std::vector<std::optional<FrameOfRange>> frames;
  std::vector<std::vector<std::vector<fs::path>>> outputs;  // of each, of each picture
  SceneFile first;
};

// Throws nothing that is wrong with the scene, but tells it; `exit_code` is not 0 then.
Frames read_frames(RenderOptions options, int& exit_code) {
  Frames result;
  result.frames = frames_to_render(options.frames);
  SceneFile file;
  for (const std::optional<FrameOfRange>& frame : result.frames) {
    const bool is_first = result.outputs.empty();
    options.frame = frame;
    if (is_first || file.varies) {
      ReadOptions read_options{.course = options.course, .lenient = options.lenient, .hash = true};
      if (frame) read_options.moment = {static_cast<double>(frame->frame), frame->time_at(0)};
      file = read_scene(options.scene, read_options);
      for (const Diagnostic& diagnostic : file.diagnostics) {
        if (is_first || diagnostic.severity == Severity::error) fmt::print(stderr, "{}", to_string(diagnostic));
      }
      exit_code = !file.found ? EX_NOINPUT : has_error(file.diagnostics) ? EX_DATAERR : 0;
    }
    auto& outputs = result.outputs.emplace_back(output_files(file.actions, options.scene, options.outputs));
    for (auto& of_picture : outputs) {
      for (fs::path& output : of_picture) {
        if (frame) output = with_frame_number(output, *frame);
      }
    }
    if (exit_code == 0 && (is_first || file.varies)) {
      exit_code = check_before_rendering(options, file.actions, outputs);
    }
    if (exit_code != 0) break;
    if (is_first) result.first = file;
  }
  return result;
}

std::vector<std::string> absolute_names(const std::vector<fs::path>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const fs::path& path : paths) names.push_back(fs::absolute(path).lexically_normal().string());
  return names;
}

Job job_for(const FarmSubmitOptions& options, const Frames& frames, const JobFolder& folder) {
  Job job;
  job.version = version;
  job.program = fs::read_symlink("/proc/self/exe").string();
  job.scene = fs::absolute(options.render.scene).lexically_normal().string();
  job.scene_hash = to_hex(frames.first.hash);
  job.options = options.words;
  job.threads = std::max(1, options.render.threads);
  job.partition = options.partition;
  job.minutes = options.minutes;
  job.name = name_of_job(options.render.outputs.front(), folder.path());
  if (const auto& range = options.render.frames.range) {
    const auto digits = std::max<std::size_t>(fmt::formatted_size("{}", range->last), 4);
    job.frames = {range->first, range->last, range->step, static_cast<int>(digits)};
  }
  for (const auto& of_frame : frames.outputs) {
    std::vector<std::vector<std::string>>& names = job.outputs.emplace_back();
    for (const auto& of_picture : of_frame) names.push_back(absolute_names(of_picture));
  }
  job.pictures = static_cast<int>(job.outputs.front().size());
  const int tiles = tile_count(frames.first, options.render);
  job.shards = options.shards.value_or(good_number_of_shards(static_cast<int>(job.outputs.size()), tiles, job));
  if (job.shards > tiles) {
    throw FileError(EX_USAGE, fmt::format("--shards {}: the picture has {} tiles only", job.shards, tiles));
  }
  if (job.shards > most_units / static_cast<int>(job.outputs.size())) {
    throw FileError(EX_USAGE, fmt::format("--shards {}: with {} frames, that is more than {} parts", job.shards,
                                          job.outputs.size(), most_units));
  }
  return job;
}

void tell_commands(const JobFolder& folder, const std::vector<std::string>& shards) {
  fmt::print("nothing is submitted; this would do it:\n  {}\n  {}\n", shell_words(shards),
             shell_words(merge_command_after(folder, {"ID"})));
}

}  // namespace

int farm_submit(const FarmSubmitOptions& options) {
  int exit_code = 0;
  const Frames frames = read_frames(options.render, exit_code);
  if (exit_code != 0) return exit_code;

  const std::string place = options.folder.empty() ? options.render.outputs.front() + ".farm" : options.folder;
  const JobFolder folder(fs::absolute(place).lexically_normal());
  require_free(folder);
  const Job job = job_for(options, frames, folder);
  folder.create(job);
  fmt::print("{}: {} parts in {} tasks, in `{}`\n", job.name, job.units(), job.tasks(), folder.path().string());

  std::set<int> tasks;
  for (int task = 0; task < job.tasks(); task++) tasks.insert(task);
  const std::vector<std::string> command = shards_command(folder, tasks);
  if (options.dry_run) {
    tell_commands(folder, command);
    return 0;
  }
  const std::string id = submit(command);
  JobState state;
  state.submitted = true;
  folder.write(state);
  const std::string merge_id = submit(merge_command_after(folder, {id}));
  fmt::print("submitted: {} renders, {} puts together; `penumbra farm status {}` tells how far they are\n", id,
             merge_id, shell_word(place));
  return 0;
}

}  // namespace penumbra
