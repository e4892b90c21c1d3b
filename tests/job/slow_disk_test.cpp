// A disk that flushes slowly must not fill the memory with frames, and frames must not wait for each other's flushes.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <numeric>
#include <thread>

#include "tests/job/fake_renderer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {
std::atomic<int> flush_milliseconds{0}, flushing{0}, max_flushing{0}, interruptions{0};
}

// Stands in for the C library's fsync in this program.
extern "C" int fsync(int file) {
  if (interruptions > 0 && interruptions-- > 0) {
    errno = EINTR;
    return -1;
  }
  const int now = ++flushing;
  int max = max_flushing;
  while (now > max && !max_flushing.compare_exchange_weak(max, now)) {
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(flush_milliseconds));
  --flushing;
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace morphcl {
namespace {

using namespace job_test;

TEST(SlowDisk, FramesInMemoryStayBoundedAndFlushesOverlap) {
  flush_milliseconds = 20;
  for (const auto& [threads, in_flight] : {std::pair{1, 1}, {2, 3}}) {
    const test_support::TemporaryFolder folder;
    FakeRenderer renderer;
    std::atomic<int> drawn{0}, written{0}, max_at_once{0};
    renderer.before_draw = [&](std::int64_t) { max_at_once = std::max<int>(max_at_once, ++drawn - written); };
    std::vector<std::int64_t> frames(40);
    std::iota(frames.begin(), frames.end(), 0);
    RenderJob job = job_of(folder / "a.##.exr", frames);
    job.threads = threads;
    job.frames_in_flight = in_flight;
    job.on_frame = [&](const FrameResult&) { ++written; };
    max_flushing = 0;
    run(job, empty_scene(), renderer);
    EXPECT_EQ(written, 40);
    EXPECT_LE(renderer.buffers.size(), static_cast<std::size_t>(in_flight));
    EXPECT_LE(max_at_once, in_flight + threads + 4) << "frames drawn and not yet on the disk";
    EXPECT_GT(max_at_once, in_flight + 1) << "the renderer waited for the disk";
    EXPECT_GT(max_flushing, threads) << "flushes wait for each other";
  }
  flush_milliseconds = 0;
}

TEST(InterruptedFlush, IsTriedAgain) {
  const test_support::TemporaryFolder folder;
  FakeRenderer renderer;
  interruptions = 7;
  const JobResult result = run(job_of(folder / "a.##.exr", {1, 2}), empty_scene(), renderer);
  EXPECT_LE(interruptions, 0);
  for (const FrameResult& frame : result.frames) EXPECT_EQ(frame.status, FrameResult::Status::rendered) << frame.error;
}

}  // namespace
}  // namespace morphcl
