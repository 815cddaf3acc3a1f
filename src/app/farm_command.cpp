#include "app/farm_command.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "app/farm_collect.hpp"
#include "app/farm_submit.hpp"
#include "app/part_file.hpp"
#include "base/atomic_file.hpp"
#include "farm/scripts.hpp"
#include "farm/slurm.hpp"
#include "farm/slurm_time.hpp"
#include "farm/status.hpp"
#include "farm/survey.hpp"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

constexpr int always = 1'000'000'000;

int checked_shards(const std::string& text) {
  int number = 0;
  if (!CLI::detail::lexical_cast(text, number) || number < 1 || number > most_shards) {
    throw CLI::ValidationError("--shards",
                               fmt::format("expected a number from 1 to {}, or auto; found `{}`", most_shards, text));
  }
  return number;
}

int checked_minutes(const std::string& text) {
  const std::optional<int> minutes = slurm_minutes(text);
  if (!minutes) {
    throw CLI::ValidationError("--time",
                               fmt::format("expected a time such as 30m, 2h, 2:00:00 or 1-12:00; found `{}`", text));
  }
  return *minutes;
}

void require_partition(const std::string& name) {
  const auto is_good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_-.,+", c); };
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_good)) {
    throw CLI::ValidationError("--partition", fmt::format("there can be no partition `{}`", name));
  }
}

// The words of an option as they were given, under the name that `render` knows.
void add_words(const CLI::Option& option, const std::string& name, std::vector<std::string>& words) {
  const bool is_flag = option.get_items_expected_max() == 0;
  for (const std::string& value : option.results()) {
    words.push_back(name);
    if (!is_flag) words.push_back(value);
  }
}

// `submit` takes what `render` takes, but for what every shard is told in a way of its own.
void add_submit(CLI::App& farm, FarmOptions& farm_options) {
  FarmSubmitOptions& options = farm_options.submit;
  CLI::App* const submit = add_render(farm, options.render);
  submit->name("submit")->description("Write the scripts of a job and hand them to Slurm");
  for (const char* own :
       {"--checkpoint", "--every", "--resume", "--time-limit", "--shard", "--scene-hash", "--progress", "--stats",
        "--quiet", "--debug-pixel", "--time", "--frame", "--video", "--fps"}) {
    if (CLI::Option* const option = submit->get_option_no_throw(own)) submit->remove_option(option);
  }
  std::vector<CLI::Option*> of_picture = submit->get_options();
  std::erase_if(of_picture, [](const CLI::Option* option) {
    const std::string name = option->get_name();
    return name == "SCENE" || name == "--help" || name == "--output" || name == "--frames";
  });
  CLI::Option* const shutter_time =
      submit->add_option("--shutter-time", options.render.time, "The --time of render: freeze the shutter [no]");
  submit->get_option("--output")->required();
  submit
      ->add_option_function<std::string>(
          "--shards",
          [&options](const std::string& text) {
            if (text != "auto") options.shards = checked_shards(text);
          },
          "Pieces of each frame, or auto: four for each task that can run at once [auto]")
      ->type_name("N|auto");
  submit->add_option("--partition", options.partition, "Slurm's partition [Slurm's default]")
      ->each([](const std::string& name) { require_partition(name); })
      ->type_name("P");
  submit
      ->add_option_function<std::string>(
          "--time", [&options](const std::string& text) { options.minutes = checked_minutes(text); },
          "Slurm's time limit of a task, at whose end it saves and goes on in another turn: 30m, 2h [Slurm's default]")
      ->type_name("T");
  submit->add_option("--folder", options.folder, "The job folder, which all nodes must see [OUT.farm]")
      ->type_name("FOLDER");
  submit->add_flag("--dry-run", options.dry_run, "Write the scripts and submit nothing [off]");
  submit->parse_complete_callback([&farm_options, &options, of_picture, shutter_time] {
    farm_options.task = FarmOptions::Task::submit;
    options.words.clear();
    for (const CLI::Option* option : of_picture) add_words(*option, option->get_name(), options.words);
    add_words(*shutter_time, "--time", options.words);
  });
}

constexpr const char* job_help = "The job folder, the picture it makes, or its scene";

// The folder that a user names by its own name, by the picture's, or by that of the scene where that has one job only.
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
  fmt::print("{}", options.json ? to_json(job, status, now) : to_text(job, status, now));
  return 0;
}

}  // namespace

CLI::App* add_farm(CLI::App& app, FarmOptions& options) {
  CLI::App* const farm = app.add_subcommand("farm", "Render on a cluster: submit, status, collect");
  farm->require_subcommand(1);
  add_submit(*farm, options);

  CLI::App* const status = farm->add_subcommand("status", "Tell how far a job is");
  status->add_option("JOB", options.status.job, job_help)->required();
  status->add_flag("--json", options.status.json, "As JSON [off]");
  status->callback([&options] { options.task = FarmOptions::Task::status; });

  CLI::App* const collect = farm->add_subcommand("collect", "Put together what a job has rendered, finish what is not");
  collect->add_option("JOB", options.collect.job, job_help)->required();
  CLI::Option* const resubmit =
      collect
          ->add_option_function<std::string>(
              "--resubmit",
              [&options](const std::string& text) {
                int most = always;
                if (!text.empty() && (!CLI::detail::lexical_cast(text, most) || most < 0)) {
                  throw CLI::ValidationError("--resubmit", fmt::format("expected a number; found `{}`", text));
                }
                options.collect.resubmit = most;
              },
              "Submit what is missing again, unless that was done N times already [no]")
          ->expected(0, 1)
          ->type_name("N");
  collect->add_flag("--render", options.collect.render, "Render here what is missing [off]")->excludes(resubmit);
  collect->callback([&options] { options.task = FarmOptions::Task::collect; });
  return farm;
}

int farm_command(const FarmOptions& options) {
  try {
    if (options.task == FarmOptions::Task::submit) return farm_submit(options.submit);
    if (options.task == FarmOptions::Task::status) return farm_status(options.status);
    return farm_collect(find_job(options.collect.job), options.collect);
  } catch (const FileError& error) {
    fmt::print(stderr, "penumbra: {}\n", error.what());
    return error.exit_code;
  } catch (const SlurmError& error) {
    fmt::print(stderr, "penumbra: Slurm does not do it: {}\n", error.what());
    return EX_UNAVAILABLE;
  }
}

}  // namespace penumbra
