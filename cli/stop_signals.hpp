// TERM, INT, USR1 and HUP (unless the shell had it ignored, as nohup does) ask the process to stop. The first one sets
// a flag, by which a command ends as soon as what it has drawn is written. Where the flag is not looked at in time,
// since a large file is read, kernels are compiled or a frame is drawn, the process is ended 1.5 seconds later, with
// nothing left behind; the frame that was being drawn is lost. A second signal ends it at once, with 128 + its number,
// and with nothing left behind either.
//
// A thread of its own waits for these signals, which are blocked in all others: so they arrive, whatever handlers a
// library installs (LLVM, in PoCL, puts its own over all that it finds). SIGPIPE and SIGXFSZ are blocked as well, so
// that a closed stdout or a file size limit is an error to report and not the end of a job.
#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace morphcl::cli {

// For main(), before there is another thread.
void watch_stop_signals();

// From now on abort(), by which PoCL ends the process where it cannot write or start what it needs, is an error in one
// line, exit code 69, and leaves nothing behind. For who is about to open a device.
void watch_driver_aborts();

// The flag of this process.
const std::atomic<bool>& stop_requested();

// What a command says of itself to the thread that may have to end it.
struct StopPlan {
  std::function<bool()> may_end;       // nothing is lost but what can be had by another run; empty: always
  std::function<std::string()> words;  // for stderr; empty: nothing is said
};

// Of the whole command, as long as it lives; without one the words are "interrupted".
class StopPlanScope {
 public:
  explicit StopPlanScope(StopPlan plan);
  ~StopPlanScope();
  StopPlanScope(const StopPlanScope&) = delete;
  StopPlanScope& operator=(const StopPlanScope&) = delete;
};

}  // namespace morphcl::cli
