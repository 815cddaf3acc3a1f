// `penumbra farm`: one frame or many, divided among the tasks of a scheduler. `submit` writes a job folder and hands
// its scripts to Slurm, `status` shows the progress, `collect` merges the parts.
#pragma once

#include "app/farm/farm_options.hpp"

namespace penumbra {

// The subcommand `farm` and those below it; their options write to `options`, which must outlive it.
Subcommand farm_subcommand(FarmOptions& options);

}  // namespace penumbra
