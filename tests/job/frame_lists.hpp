// Frames that a job is asked for, and frames that it reports.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "morphcl/job.hpp"

namespace morphcl::job_test {

inline std::vector<std::int64_t> range(std::int64_t first, std::int64_t last) {
  std::vector<std::int64_t> frames(static_cast<std::size_t>(last - first + 1));
  std::iota(frames.begin(), frames.end(), first);
  return frames;
}

inline std::vector<std::int64_t> frames_of(const JobResult& result, FrameResult::Status status) {
  std::vector<std::int64_t> frames;
  for (const FrameResult& frame : result.frames)
    if (frame.status == status) frames.push_back(frame.frame);
  return frames;
}

}  // namespace morphcl::job_test
