// How many threads this process may use.
#pragma once

namespace morphcl {

constexpr int max_threads = 4096;

// `requested` if it is positive, else SLURM_CPUS_PER_TASK if that holds a number from 1 to max_threads, else the number
// of processors in the affinity mask. Error(usage) if requested is negative or above max_threads.
int choose_thread_count(int requested);

}  // namespace morphcl
