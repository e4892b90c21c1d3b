// A job that is killed in the middle leaves whole frames only, and the next run completes it.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "host/temporary_file.hpp"
#include "morphcl/exr.hpp"
#include "tests/job/fake_renderer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace job_test;
using test_support::TemporaryFolder;

RenderJob slow_job(const TemporaryFolder& folder) {
  std::vector<std::int64_t> frames;
  for (std::int64_t frame = 0; frame < 40; ++frame) frames.push_back(frame);
  return job_of(folder / "shot.####.exr", frames);
}

pid_t start(const TemporaryFolder& folder) {
  const pid_t pid = fork();
  if (pid != 0) return pid;
  FakeRenderer renderer;
  renderer.before_draw = [](std::int64_t) { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
  run(slow_job(folder), empty_scene(), renderer);
  _exit(0);
}

std::size_t finished_names(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for (const std::string& name : folder.names()) count += name.starts_with("shot.");
  return count;
}

TEST(KilledJob, LeavesWholeFramesAndIsCompletedByResume) {
  for (const std::size_t kill_after : {1u, 7u, 20u}) {
    const TemporaryFolder folder;
    const pid_t pid = start(folder);
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (finished_names(folder) < kill_after && std::chrono::steady_clock::now() < give_up)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(pid, SIGKILL);
    int status = 0;
    waitpid(pid, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the job ended before it was killed";

    const std::size_t finished = finished_names(folder);
    EXPECT_GE(finished, kill_after);
    RenderJob job = slow_job(folder);
    for (const std::string& name : folder.names()) {
      if (!name.starts_with("shot.")) continue;
      EXPECT_TRUE(is_finished_frame(folder / name, fingerprint(empty_scene()))) << name;
    }

    job.resume = true;
    FakeRenderer renderer;
    const JobResult result = run(job, empty_scene(), renderer);
    EXPECT_EQ(renderer.rendered.size(), 40 - finished);
    ASSERT_EQ(result.frames.size(), 40u);
    for (const FrameResult& frame : result.frames) {
      EXPECT_EQ(frame.hash, pixel_hash(pixels_of(frame.frame)));
      EXPECT_EQ(read_exr(frame.path).hash, frame.hash);
    }
    EXPECT_EQ(folder.names().size(), 40u) << "the killed job's temporary files are gone";
  }
}

// The temporary name that a process which is gone would have used for `file`.
std::string stale_temporary(const std::string& file) {
  const pid_t pid = fork();
  if (pid == 0) _exit(0);
  waitpid(pid, nullptr, 0);
  return std::filesystem::path(temporary_name(file, pid, 0)).filename().string();
}

TEST(KilledJob, ItsTemporaryFilesAreRemovedByTheNextJobOfThePattern) {
  const TemporaryFolder folder;
  const std::string of_this = stale_temporary("shot.0003.exr"), of_another = stale_temporary("other.0003.exr");
  test_support::write_bytes(folder / of_this, {'x'});
  test_support::write_bytes(folder / of_another, {'x'});
  FakeRenderer renderer;
  run(job_of(folder / "shot.####.exr", {1, 2}), empty_scene(), renderer);
  EXPECT_EQ(folder.names(), (std::set<std::string>{of_another, "shot.0001.exr", "shot.0002.exr"}));
}

}  // namespace
}  // namespace morphcl
