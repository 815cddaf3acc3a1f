#pragma once

#include "app/farm/farm_options.hpp"
#include "farm/job.hpp"

namespace penumbra {

// Writes the pictures of all frames whose parts exist, and deals with the other frames as the options say. Returns the
// exit code. Throws FileError and SlurmError.
int farm_collect(const JobFolder& folder, const FarmCollectOptions& options);

}  // namespace penumbra
