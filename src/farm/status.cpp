#include "farm/status.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/atomic_file.hpp"
#include "base/json_text.hpp"

namespace penumbra {
namespace {

// Assumes that the current tasks keep running, on units of equal length.
double time_left(const JobStatus& status, const Queue& queue, const Job& job, double seconds_of_unit) {
  double work = seconds_of_unit * static_cast<double>(status.waiting.size());
  double longest = 0;
  for (const int unit : status.running) {
    const double ran = job.units() > job.tasks() ? seconds_of_unit / 2 : queue.tasks.at(job.task_of(unit)).seconds;
    const double left = std::max(seconds_of_unit - ran, seconds_of_unit / 10);
    work += left;
    longest = std::max(longest, left);
  }
  return std::max(work / static_cast<double>(status.running.size()), longest);
}

// "12 s", "5 min", "1 h 05 min".
std::string span_text(double seconds) {
  const auto minutes = static_cast<long>(std::ceil(seconds / 60));
  if (seconds < 90) return fmt::format("{:.0f} s", std::ceil(seconds));
  return minutes < 60 ? fmt::format("{} min", minutes) : fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

WallClock::time_point later(WallClock::time_point now, double seconds) {
  return now + std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(seconds));
}

std::string row(const char* name, const std::set<int>& units, bool tells_which) {
  if (units.empty()) return {};
  return fmt::format("  {:<8} {:>6}{}\n", name, units.size(), tells_which ? "   " + ranges(units) : "");
}

}  // namespace

std::vector<bool> units_done(const Job& job, const JobFolder& folder,
                             const std::function<bool(const std::filesystem::path&)>& is_whole) {
  std::vector<bool> done(static_cast<std::size_t>(job.units()));
  for (int unit = 0; unit < job.units(); unit++) {
    bool all = true;
    for (int picture = 1; all && picture <= job.pictures; picture++) {
      const std::filesystem::path part = folder.part(job, unit, picture);
      std::error_code error;
      all = std::filesystem::is_regular_file(part, error) && is_whole(part);
    }
    done[static_cast<std::size_t>(unit)] = all;
  }
  return done;
}

std::optional<double> seconds_of_unit(const Job& job, const JobFolder& folder) {
  constexpr int enough = 100;
  const int step = std::max(1, job.units() / enough);
  double sum = 0;
  int count = 0;
  for (int unit = 0; unit < job.units(); unit += step) {
    try {
      const Json stats = json_from(read_file(folder.stats(unit)));
      for (const char* what : {"parse_seconds", "build_seconds", "render_seconds", "write_seconds"}) {
        sum += stats.at(what).as<double>();
      }
      count++;
    } catch (const std::exception&) {  // not rendered yet, or not by this program: the others are enough
    }
  }
  return count == 0 ? std::nullopt : std::optional(sum / count);
}

JobStatus status_of(const Job& job, const JobState& state, const std::vector<bool>& done,
                    const std::optional<Queue>& queue, const std::string& silence,
                    std::optional<double> seconds_of_unit) {
  JobStatus status;
  status.silence = silence;
  status.resubmissions = state.resubmissions;
  status.merged = state.finished.size() == job.outputs.size();
  status.merge_queued = queue && queue->merge;
  std::set<int> busy;  // tasks whose running unit is found
  for (int unit = 0; unit < job.units(); unit++) {
    if (done[static_cast<std::size_t>(unit)]) {
      status.done.insert(unit);
    } else if (!queue) {
      status.unknown.insert(unit);
    } else if (const auto task = queue->tasks.find(job.task_of(unit)); task == queue->tasks.end()) {
      status.lost.insert(unit);
    } else if (task->second.runs && busy.insert(task->first).second) {
      status.running.insert(unit);
    } else {
      status.waiting.insert(unit);
      if (!task->second.runs) status.reasons.insert(task->second.reason);
    }
  }
  if (seconds_of_unit && !status.running.empty()) {
    status.seconds_left = time_left(status, *queue, job, *seconds_of_unit);
  }
  return status;
}

std::string to_text(const Job& job, const JobStatus& status, WallClock::time_point now) {
  std::string text = fmt::format("{}: {} of {} parts are done", job.name, status.done.size(), job.units());
  if (job.outputs.size() > 1) text += fmt::format(" ({} frames, {} shards each)", job.outputs.size(), job.shards);
  text += '\n';
  text += row("done", status.done, false) + row("running", status.running, true) +
          row("waiting", status.waiting, true) + row("lost", status.lost, true) + row("unknown", status.unknown, true);
  if (!status.reasons.empty()) text += fmt::format("  waiting for: {}\n", fmt::join(status.reasons, ", "));
  if (status.resubmissions > 0) text += fmt::format("resubmissions: {}\n", status.resubmissions);
  const std::string& first = job.outputs.front().front().front();
  if (status.merged) {
    text += fmt::format("finished: {}{}\n", first, job.outputs.size() > 1 ? " and its frames" : "");
  } else if (!status.silence.empty()) {
    text += fmt::format("Slurm does not answer, so it is not known what runs ({})\n", status.silence);
  } else if (status.seconds_left) {
    text += fmt::format("estimated end: {:%H:%M} (in {}), if as many keep running\n",
                        fmt::localtime(WallClock::to_time_t(later(now, *status.seconds_left))),
                        span_text(*status.seconds_left));
  } else if (!status.waiting.empty()) {
    text += "estimated end: unknown until a task runs\n";
  } else if (status.merge_queued) {
    text += "the merge comes next\n";
  } else {
    text += "nothing of it is left in Slurm's queue: `penumbra farm collect` finishes it\n";
  }
  return text;
}

std::string to_json(const Job& job, const JobStatus& status, WallClock::time_point now) {
  Json json;
  json["name"] = job.name;
  json["scene"] = job.scene;
  json["outputs"] = job.outputs;
  json["parts"] = job.units();
  json["done"] = status.done.size();
  json["running"] = status.running;
  json["waiting"] = status.waiting;
  json["lost"] = status.lost;
  json["unknown"] = status.unknown;
  json["slurm"] = status.silence.empty();
  json["merge_queued"] = status.merge_queued;
  json["finished"] = status.merged;
  json["resubmissions"] = status.resubmissions;
  if (status.seconds_left) {
    json["seconds_left"] = *status.seconds_left;
    json["estimated_end"] =
        fmt::format("{:%FT%TZ}", fmt::gmtime(WallClock::to_time_t(later(now, *status.seconds_left))));
  }
  return to_text(json) + "\n";
}

}  // namespace penumbra
