#pragma once

#include "app/farm/farm_options.hpp"

namespace penumbra {

// Writes the job folder and submits its scripts. Returns the exit code. Throws FileError and SlurmError.
int farm_submit(const FarmSubmitOptions& options);

}  // namespace penumbra
