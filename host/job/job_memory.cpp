#include "host/job/job_memory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/memory_room.hpp"

namespace morphcl {

namespace {

constexpr std::uint64_t max_buffer_bytes = std::uint64_t{2} << 30;

// What each part of a job takes. A frame's file is reckoned with half of its pixels, which rendered ones do not reach,
// or with all of them where nothing is compressed.
struct JobCosts {
  std::uint64_t fixed, buffer, writer, checker;

  JobCosts(const RenderJob& job, const ImageSettings& image, const Renderer::Memory& drawing) {
    const std::uint64_t pixels = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
    const std::uint64_t frame = pixels * pixel_bytes(image.channels);
    const std::uint64_t file = image.compression == "none" ? frame : frame / 2;
    const std::uint64_t pictures = job.preview || !job.contact_sheet.empty() ? 6 * pixels : 0;  // colours and PNG
    const std::uint64_t samples = image.samples > 1 ? static_cast<std::uint64_t>(image.samples) : 0;
    fixed = drawing.fixed + (drawing.per_pixel + drawing.per_sample * samples) * pixels;
    buffer = frame;
    writer = file * (job.reuse_equal_frames ? 2 : 1) + (job.verify ? frame : 0) + pictures;
    checker = file + frame + pictures;
  }

  std::uint64_t of(const WriteQueue::Limits& queue) const {
    return fixed + static_cast<std::uint64_t>(queue.buffers) * buffer +
           static_cast<std::uint64_t>(queue.threads) * writer;
  }
};

// As many as fit in what at most may be taken.
int fitting(std::uint64_t bytes, std::uint64_t each, int min, int max) {
  const std::uint64_t count = bytes / std::max<std::uint64_t>(1, each);
  return static_cast<int>(std::clamp<std::uint64_t>(count, static_cast<std::uint64_t>(min),
                                                    static_cast<std::uint64_t>(std::max(min, max))));
}

}  // namespace

JobLimits job_limits(const RenderJob& job, const ImageSettings& image, const Renderer::Memory& drawing, int threads,
                     std::uint64_t room) {
  const JobCosts costs(job, image, drawing);
  JobLimits limits;
  WriteQueue::Limits& queue = limits.queue;
  queue.buffers =
      job.frames_in_flight > 0 ? job.frames_in_flight : fitting(max_buffer_bytes, costs.buffer, 2, threads + 1);
  // Threads that wait for the disk are in nobody's way.
  queue.threads = fitting(max_buffer_bytes, costs.buffer, 1, threads + 4);
  while (costs.of(queue) > room && queue.buffers + queue.threads > 2)
    --(queue.threads >= queue.buffers ? queue.threads : queue.buffers);
  limits.checkers = job.resume ? fitting(room, costs.checker, 1, threads) : 1;
  const std::uint64_t needed = std::max(costs.of(queue), job.resume ? costs.checker : 0);
  if (needed > room)
    require_memory(needed, fmt::format("a frame of {}x{}", image.width, image.height),
                   "a smaller size, fewer channels or samples, or the compression zip take less");
  return limits;
}

}  // namespace morphcl
