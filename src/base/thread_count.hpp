// How many threads the program may use.
#pragma once

namespace penumbra {

// The number of threads to use when none is given: what Slurm gives the task, else the processors this process may use.
int default_thread_count();

}  // namespace penumbra
