// TERM, INT and USR1 ask a job to stop: the first one sets a flag, a second one ends the process at once with 128 + its
// number. SIGPIPE and SIGXFSZ are ignored, so that a closed stdout or a file size limit is an error to report and not
// the end of a job.
#pragma once

#include <atomic>

namespace morphcl::cli {

// The flag of this process; set by the first signal. Installs the handlers on the first call.
const std::atomic<bool>& stop_requested();

}  // namespace morphcl::cli
