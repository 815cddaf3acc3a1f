#include <fmt/format.h>
#include <sysexits.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/farm/farm_command.hpp"
#include "app/render/outputs.hpp"
#include "app/render/render_paths.hpp"
#include "app/render/scene_frames.hpp"
#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/say.hpp"
#include "base/shell_words.hpp"
#include "base/version.hpp"
#include "farm/slurm.hpp"
#include "language/scene_file.hpp"
#include "rendering/tile_grid.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

// If Slurm does not say how many processors it has.
constexpr int usual_shards = 24;
constexpr int shards_for_each_task = 4;  // so that losing or awaiting one costs little
constexpr int tiles_worth_a_shard = 64;

// A unique name, of characters that have no meaning for Slurm.
std::string name_of_job(const fs::path& output, const fs::path& folder) {
  std::string name = output.stem().string().substr(0, 24);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  const std::string origin =
      fmt::format("{} {} {}", folder.string(), ::getpid(), std::chrono::system_clock::now().time_since_epoch().count());
  return fmt::format("{}-{:08x}", name, checksum(std::as_bytes(std::span(origin)), 0) >> 32);
}

// The number of tiles of the picture that has the fewest.
int tile_count(const SceneFile& file, const RenderOptions& options) {
  int fewest = most_units;
  for (const Action& action : file.actions) {
    const auto* picture = std::get_if<Picture>(&action);
    if (!picture) continue;
    const Settings& own = picture->scene->settings;
    const auto [width, height] = options.size.value_or(std::pair(own.width, own.height));
    const PixelRect crop = options.crop.value_or(PixelRect{0, 0, width, height});
    fewest = std::min(fewest, tiles_of(crop, options.sample_counts()).count());
  }
  return fewest;
}

int good_number_of_shards(int frames, int tiles, const Job& job) {
  const std::optional<int> processors = processors_of(job.partition);
  const int units = processors ? shards_for_each_task * std::max(1, *processors / job.threads) : usual_shards;
  const int shards = (units + frames - 1) / frames;
  return std::clamp(shards, 1, std::max(1, std::min(tiles / tiles_worth_a_shard, most_tasks)));
}

// Throws FileError unless a job can be written into the folder without losing anything of value.
void require_free(const JobFolder& folder) {
  const std::string name = folder.path().string();
  std::error_code error;
  if (!fs::exists(folder.path(), error)) return;
  if (!fs::exists(folder.manifest(), error)) {
    if (fs::is_directory(folder.path(), error) && fs::is_empty(folder.path(), error)) return;
    throw FileError(EX_CANTCREAT, fmt::format("`{}` is not a job folder; name another one with --folder", name));
  }
  if (folder.read_state().submitted || !fs::is_empty(folder.parts(), error)) {
    throw FileError(EX_CANTCREAT,
                    fmt::format("`{}` is the folder of a job that has begun: see `penumbra farm status`; remove the "
                                "folder to start over, or name another one with --folder",
                                name));
  }
}

// What a job needs to know of the scene at each frame.
struct Frames {
  std::vector<std::vector<std::vector<fs::path>>> outputs;  // [frame][picture][file]
  SceneFile first;
};

// Notes all files in `paths`, and reports errors of the scene; `exit_code` is then not 0.
Frames read_frames(const RenderOptions& options, RenderPaths& paths, int& exit_code) {
  Frames result;
  SceneFrames scenes(options, true);
  exit_code = scenes.check([&] {
    paths.add(scenes);
    result.outputs.push_back(scenes.outputs());
    if (result.outputs.size() == 1) result.first = scenes.file();
  });
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
  job.threads = std::max(1, options.render.machine.threads);
  job.partition = options.partition;
  job.minutes = options.minutes;
  job.name = name_of_job(options.render.outputs.front(), folder.path());
  if (const auto& range = options.render.frames) {
    job.frames = {range->first, range->last, range->step, frame_digits(range->last)};
  }
  for (const auto& of_frame : frames.outputs) {
    std::vector<std::vector<std::string>>& names = job.outputs.emplace_back();
    for (const auto& of_picture : of_frame) names.push_back(absolute_names(of_picture));
  }
  job.pictures = static_cast<int>(job.outputs.front().size());
  const int tiles = tile_count(frames.first, options.render);
  job.shards = options.shards.value_or(good_number_of_shards(static_cast<int>(job.outputs.size()), tiles, job));
  if (job.shards > tiles) {
    throw FileError(EX_USAGE, fmt::format("--shards {}: the picture has only {} tiles", job.shards, tiles));
  }
  if (job.shards > most_units / static_cast<int>(job.outputs.size())) {
    throw FileError(EX_USAGE, fmt::format("--shards {}: with {} frames, that is more than {} parts", job.shards,
                                          job.outputs.size(), most_units));
  }
  return job;
}

}  // namespace

int farm_submit(const FarmSubmitOptions& options) {
  int exit_code = 0;
  const std::string place = options.folder.empty() ? options.render.outputs.front() + ".farm" : options.folder;
  RenderPaths paths(options.render);
  paths.makes(place, "--folder");
  const Frames frames = read_frames(options.render, paths, exit_code);
  if (exit_code != 0) return exit_code;
  paths.try_to_write();

  const JobFolder folder(fs::absolute(place).lexically_normal());
  require_free(folder);
  const Job job = job_for(options, frames, folder);
  folder.create(job);
  print(fmt::format("{}: {} parts in {} tasks, in `{}`\n", job.name, job.units(), job.tasks(), folder.path().string()));

  std::set<int> tasks;
  for (int task = 0; task < job.tasks(); task++) tasks.insert(task);
  const std::vector<std::string> command = shards_command(folder, tasks);
  if (options.dry_run) {
    print(fmt::format("nothing was submitted; these commands would do it:\n  {}\n  {}\n", shell_words(command),
                      shell_words(merge_command_after(folder, {"ID"}))));
    return 0;
  }
  const std::string id = submit(command);
  JobState state;
  state.submitted = true;
  folder.write(state);
  const std::string merge_id = submit(merge_command_after(folder, {id}));
  print(fmt::format("submitted: {} renders, {} merges; `penumbra farm status {}` shows the progress\n", id, merge_id,
                    shell_word(place)));
  return 0;
}

}  // namespace penumbra
