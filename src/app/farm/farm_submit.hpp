#pragma once

#include "app/farm/farm_options.hpp"

namespace penumbra {

// Throws FileError and SlurmError.
int farm_submit(const FarmSubmitOptions& options);

}  // namespace penumbra
