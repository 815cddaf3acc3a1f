// How many threads the program may use.
#pragma once

namespace penumbra {

// How many threads to use when none are asked for: what Slurm gives the task, else the processors this process may use.
int default_thread_count();

}  // namespace penumbra
