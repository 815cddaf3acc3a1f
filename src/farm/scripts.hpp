// The two scripts of a job, for Slurm and equally for plain bash: `./shard.sh 7` renders task 7, `./merge.sh` does what
// comes after the last task.
#pragma once

#include <string>

#include "farm/job.hpp"

namespace penumbra {

std::string shard_script(const Job& job, const JobFolder& folder);
std::string merge_script(const Job& job, const JobFolder& folder);

inline constexpr int most_resubmissions = 3;  // by the merge

// The name of a job's merge in Slurm.
inline std::string merge_name(const Job& job) { return job.name + "-merge"; }

}  // namespace penumbra
