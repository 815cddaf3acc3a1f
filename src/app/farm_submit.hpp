#pragma once

#include "app/farm_command.hpp"

namespace penumbra {

// Throws FileError and SlurmError.
int farm_submit(const FarmSubmitOptions& options);

}  // namespace penumbra
