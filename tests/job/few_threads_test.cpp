// Where the system starts few threads, or none.
#include <ImfThreading.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "morphcl/exr.hpp"
#include "tests/job/fake_renderer.hpp"
#include "tests/support/exit_code_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace job_test;
using test_support::exit_code_of;
using test_support::TemporaryFolder;

// A job of a user who may have so many threads beside the first one: how it ended, 0 or an error's exit code. Only root
// can be another user.
int run_with_threads(rlim_t threads, const RenderJob& job, const Scene& scene = empty_scene()) {
  Imf::setGlobalThreadCount(0);  // a forked process would wait for threads that it does not have
  return exit_code_of([&] {
    const rlimit limit = {threads + 1, threads + 1};
    setrlimit(RLIMIT_NPROC, &limit);
    if (setuid(1'000'000 + static_cast<uid_t>(getpid())) != 0) _exit(1);
    alarm(20);  // for who waits for a thread that never started
    FakeRenderer renderer;
    run(job, scene, renderer);
  });
}

TEST(FewThreads, AreEnoughAndNoneIsAnError) {
  if (geteuid() != 0) return;
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  RenderJob job = job_of(folder / "a.##.exr", {0, 1, 2, 3, 4, 5});
  job.threads = 4;
  EXPECT_EQ(run_with_threads(0, job), static_cast<int>(ErrorKind::no_device));
  EXPECT_TRUE(folder.names().empty());
  for (const rlim_t threads : {1u, 2u, 3u}) {
    EXPECT_EQ(run_with_threads(threads, job), 0) << threads;
    for (const std::int64_t frame : job.frames)
      EXPECT_TRUE(is_finished_frame(folder / ("a.0" + std::to_string(frame) + ".exr"), fingerprint(empty_scene())));
  }
  job.resume = true;
  job.frames.push_back(6);
  EXPECT_EQ(run_with_threads(1, job), 0) << "frames are checked by threads as well";
}

// All threads share one frame.
TEST(FewThreads, EncodeASingleFrame) {
  if (geteuid() != 0) return;
  for (const std::string compression : {"zip", "zips"}) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
    RenderJob job = job_of(folder / "a.exr", {3});
    job.threads = 8;
    Scene scene = empty_scene();
    scene.image.compression = compression;
    EXPECT_EQ(run_with_threads(1, job, scene), 0) << compression;
    EXPECT_EQ(read_exr(folder / "a.exr").hash, pixel_hash(pixels_of(3)));
  }
}

}  // namespace
}  // namespace morphcl
