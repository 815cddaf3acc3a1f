// Which units of a job are done, by what lies in its folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "farm/job.hpp"

namespace penumbra {

// For each unit whether all its parts are there. `is_whole` is asked for those that are; it need not read all of them.
std::vector<bool> units_done(const Job& job, const JobFolder& folder,
                             const std::function<bool(const std::filesystem::path&)>& is_whole);

// What a unit takes from start to end, in seconds: the mean over some of those that were rendered; none without any.
std::optional<double> seconds_of_unit(const Job& job, const JobFolder& folder);

}  // namespace penumbra
