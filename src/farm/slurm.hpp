// Has Slurm run the tasks of a job, and asks it about their state.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "farm/job.hpp"

namespace penumbra {

// Slurm did not do what it was asked to do; holds its message.
struct SlurmError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The commands that submit these tasks, and the merge after the jobs with these ids have ended in any way.
std::vector<std::string> shards_command(const JobFolder& folder, const std::set<int>& tasks);
std::vector<std::string> merge_command_after(const JobFolder& folder, const std::set<std::string>& ids);

// Runs such a command. Returns the job id. Throws SlurmError.
std::string submit(const std::vector<std::string>& command);

struct QueuedTask {
  bool runs = false;   // else it waits
  std::string state;   // as Slurm calls it
  std::string reason;  // why it waits
  double seconds = 0;  // since it started
};

// What Slurm still has to do for a job.
struct Queue {
  std::map<int, QueuedTask> tasks;
  std::optional<QueuedTask> merge;
  std::set<std::string> ids;  // job ids of the task arrays
};

// Throws SlurmError.
Queue queue_of(const Job& job);
Queue parse_queue(const Job& job, const std::string& lines);

// The number of processors in all nodes of a partition; none if Slurm does not say.
std::optional<int> processors_of(const std::string& partition);

// The minutes, rounded up, of "90" (minutes), "MM:SS", "HH:MM:SS", "D-HH", "D-HH:MM", "D-HH:MM:SS", or a number with
// its unit: "90s", "30m", "2h", "1d". None for any other text, for 0 and for more than a year.
std::optional<int> slurm_minutes(std::string_view text);

}  // namespace penumbra
