// `penumbra farm`: one frame or many, shared out among the tasks of a scheduler. `submit` writes a job folder and hands
// its scripts to Slurm, `status` tells how far they are, `collect` puts the parts together.
#pragma once

#include "app/farm/farm_options.hpp"

namespace penumbra {

// The subcommand `farm` and those below it; their options fill `options`, which has to outlive it.
Subcommand farm_subcommand(FarmOptions& options);

}  // namespace penumbra
