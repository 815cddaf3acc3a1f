// The progress of a job, from what its folder and Slurm say.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "farm/job.hpp"
#include "farm/slurm.hpp"

namespace penumbra {

// For each unit, whether all its parts exist and are whole by `is_whole`, which need not read them completely.
std::vector<bool> units_done(const Job& job, const JobFolder& folder,
                             const std::function<bool(const std::filesystem::path&)>& is_whole);

// The seconds that a unit takes from start to end: the mean over some of the rendered ones; none if there are none.
std::optional<double> seconds_of_unit(const Job& job, const JobFolder& folder);

struct JobStatus {
  std::set<int> done, running, waiting;  // units
  std::set<int> lost;                    // neither done nor known to Slurm
  std::set<int> unknown;                 // not done, and Slurm does not answer
  bool merged = false;                   // all pictures are written
  bool merge_queued = false;
  int resubmissions = 0;
  std::string silence;                 // why Slurm does not answer; empty where it does
  std::set<std::string> reasons;       // why tasks wait
  std::optional<double> seconds_left;  // if as many tasks keep running
};

// `queue` is empty if Slurm does not answer, and `silence` says why.
JobStatus status_of(const Job& job, const JobState& state, const std::vector<bool>& done,
                    const std::optional<Queue>& queue, const std::string& silence,
                    std::optional<double> seconds_of_unit);

using WallClock = std::chrono::system_clock;

std::string to_text(const Job& job, const JobStatus& status, WallClock::time_point now);
std::string to_json(const Job& job, const JobStatus& status, WallClock::time_point now);

}  // namespace penumbra
