#include "app/farm/farm_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <filesystem>

#include "app/merge/part_file.hpp"
#include "app/options/shared_options.hpp"
#include "app/render/outputs.hpp"
#include "base/atomic_file.hpp"
#include "base/say.hpp"
#include "farm/slurm.hpp"
#include "farm/status.hpp"
#include "picture/option_text.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr int always = 1'000'000'000;

std::string take_shards(FarmSubmitOptions& options, std::string_view text) {
  options.shards.reset();
  if (text == "auto") return {};
  if (!parse_whole(text, 1, most_shards, options.shards).empty()) {
    return expected(text, fmt::format("a number from 1 to {}, or auto", most_shards));
  }
  return {};
}

std::string take_minutes(FarmSubmitOptions& options, std::string_view text) {
  options.minutes = slurm_minutes(std::string(text));
  return options.minutes ? std::string() : expected(text, "a time such as 30m, 2h, 2:00:00 or 1-12:00");
}

std::string take_partition(FarmSubmitOptions& options, std::string_view name) {
  const auto is_good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-.,+", c); };
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_good)) {
    return fmt::format("`{}` cannot be the name of a partition", name);
  }
  options.partition = name;
  return {};
}

// The same option, which also records its words as given, under its name in `render`.
CommandOption keeping_words(CommandOption option, const std::string& name, std::vector<std::string>& words) {
  const bool is_flag = option.metavar.empty(), follows_equals = option.times == Times::equals_optional;
  option.take = [take = std::move(option.take), name, is_flag, follows_equals, &words](std::string_view text) {
    words.push_back(follows_equals && !text.empty() ? fmt::format("{}={}", name, text) : name);
    if (!is_flag && !follows_equals) words.emplace_back(text);
    return take(text);
  };
  return option;
}

// `submit` takes the options of `render`, except those that the shard script sets or that do not apply to shards.
Subcommand submit_subcommand(FarmSubmitOptions& options) {
  constexpr std::array<std::string_view, 15> own = {
      "--keep-checkpoint", "--checkpoint",  "--every",    "--resume", "--time-limit",
      "--shard",           "--scene-hash",  "--progress", "--stats",  "--quiet",
      "--video",           "--debug-pixel", "--fps",      "--time",   "--frame"};
  constexpr std::array<std::string_view, 3> of_job = {"SCENE", "-o,--output", "--frames"};
  const auto is_among = [](const auto& names, const CommandOption& option) {
    return std::find(names.begin(), names.end(), option.name) != names.end();
  };
  Subcommand render = render_subcommand(options.render);
  Subcommand submit{"submit", "Write the scripts of a job and hand them to Slurm", {}, {}, {}, {}, {}, {}};
  for (CommandOption& option : render.options) {
    if (is_among(own, option)) continue;
    if (option.name == "-o,--output") option.required = true;
    submit.options.push_back(is_among(of_job, option) ? option : keeping_words(option, option.name, options.words));
  }
  CommandOption shutter_time = picture_option(options.render, "time");
  shutter_time.name = "--shutter-time";
  shutter_time.help = "The --time of render: freeze the shutter [no]";
  submit.options.push_back(keeping_words(shutter_time, "--time", options.words));
  const auto take = [&options](auto set) {
    return [&options, set](std::string_view text) { return set(options, text); };
  };
  submit.options.push_back({"--shards", "N|auto",
                            "Shards of each frame, or auto: four for each task that can run at once [auto]",
                            take(take_shards)});
  submit.options.push_back({"--partition", "P", "Slurm's partition [Slurm's default]", take(take_partition)});
  submit.options.push_back({"--time", "T",
                            "Slurm's time limit of a task, which saves before it and resumes on its next turn: 30m, 2h "
                            "[Slurm's default]",
                            take(take_minutes)});
  submit.options.push_back(
      {"--folder", "FOLDER", "The job folder, which all nodes must see [OUT.farm]", into(options.folder)});
  submit.options.push_back({"--dry-run", "", "Write the scripts and submit nothing [off]", into(options.dry_run)});
  submit.check = [&options, check = render.check] {
    if (options.render.scene == standard_input || has_standard_output(options.render.outputs)) {
      return std::string("SCENE, -o: the machines of the cluster read and write files, not the pipes of this command");
    }
    return check();
  };
  return submit;
}

// Wraps `run` so that failures of Slurm become messages. The exit codes: 0; 64; 65 if the scene or a part is wrong or
// parts are missing; 66 if there is no such scene or job; 69 if Slurm does not answer; 73, 74; 75 if tasks are still
// running.
template <class Run>
std::function<int()> guarded(Run run) {
  return [run] {
    try {
      return run();
    } catch (const SlurmError& error) {
      complain(fmt::format("Slurm failed: {}", error.what()));
      return EX_UNAVAILABLE;
    }
  };
}

constexpr const char* job_help = "The job folder, the picture it makes, or its scene";

// Finds a job by its folder, by its picture, or by its scene if that has only one job.
JobFolder find_job(const std::string& name) {
  const auto has_job = [](const fs::path& folder) {
    std::error_code error;
    return fs::exists(folder / "job.json", error);
  };
  if (has_job(name)) return JobFolder(fs::absolute(name));
  if (has_job(name + ".farm")) return JobFolder(fs::absolute(name + ".farm"));
  const fs::path scene = fs::absolute(name).lexically_normal();
  std::vector<fs::path> found;
  std::vector<fs::path> places = {fs::current_path()};
  if (scene.parent_path() != places.front()) places.push_back(scene.parent_path());
  for (const fs::path& place : places) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(place, error)) {
      if (!has_job(entry.path())) continue;
      if (fs::path(JobFolder(entry.path()).read_job().scene).lexically_normal() == scene) found.push_back(entry.path());
    }
  }
  if (found.size() == 1) return JobFolder(found.front());
  if (found.empty()) {
    throw FileError(EX_NOINPUT, fmt::format("`{}` is neither the folder nor the picture nor the scene of a job; name "
                                            "the folder, which is PICTURE.farm unless another was chosen",
                                            name));
  }
  throw FileError(EX_NOINPUT, fmt::format("`{}` has several jobs, among them `{}` and `{}`: name one of them", name,
                                          found[0].string(), found[1].string()));
}

int farm_status(const FarmStatusOptions& options) {
  const JobFolder folder = find_job(options.job);
  const Job job = folder.read_job();
  std::optional<Queue> queue;
  std::string silence;
  try {
    queue = queue_of(job);
  } catch (const SlurmError& error) {
    silence = error.what();
  }
  const JobStatus status = status_of(job, folder.read_state(), units_done(job, folder, ends_as_part_file), queue,
                                     silence, seconds_of_unit(job, folder));
  const auto now = WallClock::now();
  print(options.json ? to_json(job, status, now) : to_text(job, status, now));
  return 0;
}

}  // namespace

Subcommand farm_subcommand(FarmOptions& options) {
  Subcommand submit = submit_subcommand(options.submit);
  submit.run = guarded([&options] { return farm_submit(options.submit); });

  Subcommand status{"status", "Show the progress of a job", {}, {}, {}, {}, {}, {}};
  status.options = {{"JOB", "JOB", job_help, into(options.status.job), Times::once, true},
                    {"--json", "", "Print JSON [off]", into(options.status.json)}};
  status.run = guarded([&options] { return farm_status(options.status); });

  FarmCollectOptions& collected = options.collect;
  Subcommand collect{"collect", "Merge what a job has rendered, and finish the rest", {}, {}, {}, {}, {}, {}};
  collect.options = {{"JOB", "JOB", job_help, into(collected.job), Times::once, true},
                     {"--resubmit", "N", "Resubmit what is missing, unless that was done N times already [no]",
                      [&collected](std::string_view text) {
                        collected.resubmit = always;
                        return text.empty() ? std::string() : parse_whole(text, 0, always, collected.resubmit);
                      },
                      Times::value_optional},
                     {"--render", "", "Render the missing parts on this machine [off]", into(collected.render)}};
  collect.check = [&collected] {
    return std::string(collected.render && collected.resubmit ? "--render: leave out --resubmit" : "");
  };
  collect.run = guarded([&collected] { return farm_collect(find_job(collected.job), collected); });

  Subcommand farm{"farm", "Render on a cluster: submit, status, collect", {}, {}, {}, {}, {}, {}};
  farm.subcommands = {submit, status, collect};
  return farm;
}

}  // namespace penumbra
