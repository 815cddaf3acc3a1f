// Which units of a job are done, judging by its folder.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "farm/job.hpp"

namespace penumbra {

// For each unit, whether all its parts exist and are whole by `is_whole`, which need not read them completely.
std::vector<bool> units_done(const Job& job, const JobFolder& folder,
                             const std::function<bool(const std::filesystem::path&)>& is_whole);

// The seconds that a unit takes from start to end: the mean over some of the rendered ones; none if there are none.
std::optional<double> seconds_of_unit(const Job& job, const JobFolder& folder);

}  // namespace penumbra
