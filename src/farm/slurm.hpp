// What this program asks of Slurm: to run the tasks of a job, and what has become of them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "farm/job.hpp"

namespace penumbra {

// Slurm did not do what it was asked for; what it said.
struct SlurmError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The commands that submit these tasks, and the merge after the jobs with these ids whatever becomes of them.
std::vector<std::string> shards_command(const JobFolder& folder, const std::set<int>& tasks);
std::vector<std::string> merge_command_after(const JobFolder& folder, const std::set<std::string>& ids);

// Runs such a command. Returns the id of the job. Throws SlurmError.
std::string submit(const std::vector<std::string>& command);

struct QueuedTask {
  bool runs = false;   // else it waits
  std::string state;   // Slurm's word
  std::string reason;  // why it waits
  double seconds = 0;  // since it began to run
};

// What Slurm still has to do for a job.
struct Queue {
  std::map<int, QueuedTask> tasks;
  std::optional<QueuedTask> merge;
  std::set<std::string> ids;  // of the arrays of the tasks
};

// Throws SlurmError.
Queue queue_of(const Job& job);
Queue parse_queue(const Job& job, const std::string& lines);

// How many processors a partition has, in all its nodes; none if Slurm does not say.
std::optional<int> processors_of(const std::string& partition);

}  // namespace penumbra
