// How much of a job may be in memory at the same time.
#pragma once

#include <cstdint>

#include "host/job/write_queue.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

struct JobLimits {
  WriteQueue::Limits queue;
  int checkers = 1;  // threads that decode finished frames, for resume
};

// As many threads and frame buffers as the job asks for and `room`, bytes of memory, allows; see RenderJob. `threads`
// is the job's, or one for each CPU. Error(no_device) with the numbers when not even one of each has room.
JobLimits job_limits(const RenderJob& job, const ImageSettings& image, const Renderer::Memory& drawing, int threads,
                     std::uint64_t room);

}  // namespace morphcl
