// The end of a process in which a thread may be at work that cannot be stopped: the driver's compiler. Destructors of
// the driver's globals would take its ground away, so none is run.
#pragma once

namespace morphcl {

// Ends the process at once, with nothing left behind (host/leftovers.hpp): no destructor runs, nothing is flushed. What
// the driver says of the files that have gone under its hands is not heard any more.
[[noreturn]] void end_process(int code);

// For who leaves such a thread at work: main() is then to end by end_process().
void leave_thread_at_work();
bool thread_left_at_work();

}  // namespace morphcl
