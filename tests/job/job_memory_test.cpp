// A job keeps to the memory that it is given.
#include "host/job/job_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "host/memory_room.hpp"
#include "morphcl/error.hpp"
#include "tests/support/exit_code_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using test_support::TemporaryFolder;

constexpr std::uint64_t megabyte = 1'000'000;

ImageSettings image_of(int width, int height) {
  ImageSettings image;
  image.width = width;
  image.height = height;
  return image;
}

TEST(JobMemory, WithRoomItIsAsManyAsAskedFor) {
  const JobLimits limits = job_limits({}, image_of(1920, 1080), {}, 4, 64'000 * megabyte);
  EXPECT_EQ(limits.queue.buffers, 5);
  EXPECT_EQ(limits.queue.threads, 8);
  RenderJob job;
  job.resume = true;
  job.frames_in_flight = 3;
  const JobLimits resumed = job_limits(job, image_of(1920, 1080), {}, 4, 64'000 * megabyte);
  EXPECT_EQ(resumed.queue.buffers, 3);
  EXPECT_EQ(resumed.checkers, 4);
}

// All channels of 4K take 160 bytes a pixel, 1327 MB: in each buffer, in a written file half of that.
TEST(JobMemory, ChannelsTakeRoom) {
  ImageSettings image = image_of(3840, 2160);
  image.channels = every_channel;
  static_assert(pixel_bytes(every_channel) == 160);
  RenderJob job;
  job.reuse_equal_frames = false;
  const WriteQueue::Limits queue = job_limits(job, image, {}, 4, 3 * 1991 * megabyte).queue;
  EXPECT_LE(queue.buffers * 1327 + queue.threads * 664, 3 * 1991);
  EXPECT_NO_THROW(job_limits(job, image, {}, 4, 1991 * megabyte));
  image.channels = default_channels;
  EXPECT_EQ(job_limits(job, image, {}, 4, 3 * 1991 * megabyte).queue.buffers, 5);
}

// A frame of 8K takes 398 MB, its file is reckoned with half of that.
TEST(JobMemory, WithLessItIsFewerAndThenARefusalWithTheNumbers) {
  RenderJob job;
  job.reuse_equal_frames = false;
  const ImageSettings image = image_of(7680, 4320);
  int threads = 9, buffers = 9;
  for (const std::uint64_t room : {4000u, 2000u, 1200u, 700u}) {
    const WriteQueue::Limits queue = job_limits(job, image, {}, 4, room * megabyte).queue;
    EXPECT_LE(queue.buffers * 398 + queue.threads * 199, static_cast<int>(room)) << room;
    EXPECT_LE(queue.buffers, buffers);
    EXPECT_LE(queue.threads, threads);
    buffers = queue.buffers;
    threads = queue.threads;
  }
  EXPECT_EQ(buffers, 1);
  EXPECT_EQ(threads, 1);
  job.resume = true;
  EXPECT_EQ(job_limits(job, image, {}, 4, 1250 * megabyte).checkers, 2);
}

// Limits of version 2 as the kernel has them, below a folder of the test.
TEST(MemoryRoom, OfAControlGroupOfVersion2AndTheOnesAboveIt) {
  const TemporaryFolder root;
  root.write("proc/self/cgroup", "0::/job/step\n");
  root.write(
      "proc/self/mountinfo",
      "22 1 0:20 / /proc rw - proc proc rw\n31 22 0:27 / /sys/fs/cgroup rw,nosuid shared:9 - cgroup2 cgroup2 rw\n");
  const std::string groups = "sys/fs/cgroup";
  EXPECT_EQ(control_group_room(root.path()).bytes, MemoryRoom{}.bytes);
  root.write(groups + "/job/step/memory.max", "max\n");
  root.write(groups + "/job/memory.max", "629145600\n");
  root.write(groups + "/job/memory.current", "100000000\n");
  root.write(groups + "/job/memory.stat", "anon 30000000\nfile 70000000\nshmem 20000000\n");
  const MemoryRoom room = control_group_room(root.path());
  EXPECT_EQ(room.bytes, 629145600u - (100'000'000u - 50'000'000u)) << "what files are cached can be dropped";
  EXPECT_NE(room.whose.find("629 MB"), std::string::npos);
  root.write(groups + "/job/step/memory.max", "1000000\n");
  root.write(groups + "/job/step/memory.current", "5000000\n");
  EXPECT_EQ(control_group_room(root.path()).bytes, 0u);
}

// In a container: the path is the host's, and its own group is what is mounted.
TEST(MemoryRoom, OfAControlGroupOfVersion1) {
  const TemporaryFolder root;
  root.write("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/1234\n0::/\n");
  root.write("proc/self/mountinfo",
             "32 25 0:28 /docker/1234 /sys/fs/cgroup/memory ro - cgroup cgroup rw,memory\n"
             "33 25 0:29 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n");
  root.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(control_group_room(root.path()).bytes, MemoryRoom{}.bytes);
  root.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "629145600\n");
  root.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "29145600\n");
  EXPECT_EQ(control_group_room(root.path()).bytes, 600'000'000u);
}

#ifndef MORPHCL_SANITIZED
// A process of its own, which may map so much more than this one does.
int exit_code_within(std::uint64_t bytes, int width, int height) {
  return test_support::exit_code_of([=] {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t all = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + bytes;
    const rlimit limit = {all, all};
    setrlimit(RLIMIT_AS, &limit);
    try {
      job_limits({}, image_of(width, height), {}, 2, memory_room().bytes);
    } catch (const Error& error) {
      const std::string line = error.what();
      const bool told =
          line.find("7680x4320 takes some ") != std::string::npos && line.find("and ulimit -v, ") != std::string::npos;
      if (!told) _exit(99);
      throw;
    }
  });
}

// AddressSanitizer maps terabytes.
TEST(MemoryRoom, OfUlimit) {
  EXPECT_EQ(exit_code_within(600 * megabyte, 7680, 4320), static_cast<int>(ErrorKind::no_device));
  EXPECT_EQ(exit_code_within(600 * megabyte, 640, 360), 0);
}
#endif

}  // namespace
}  // namespace morphcl
