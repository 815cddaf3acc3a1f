// The two batch scripts of a job. They are Slurm's, and plain bash for everybody else: `./shard.sh 7` does task 7,
// `./merge.sh` what comes after the last.
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
