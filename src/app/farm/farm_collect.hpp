#pragma once

#include "app/farm/farm_options.hpp"
#include "farm/job.hpp"

namespace penumbra {

// Writes the pictures of all frames whose parts are there, and sees to the others as the options say. Throws FileError
// and SlurmError.
int farm_collect(const JobFolder& folder, const FarmCollectOptions& options);

}  // namespace penumbra
