// How many threads a process takes, and that the device keeps to it.
#include "host/thread_count.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>

#include "morphcl/error.hpp"
#include "tests/device/run_device_child.hpp"
#include "tests/device/warm_cache.hpp"

namespace morphcl {
namespace {

using test_support::Environment;
using testing::ChildResult;
using testing::run_device_child;
using testing::warm_cache;

class SlurmVariable {
 public:
  explicit SlurmVariable(const char* value) { setenv("SLURM_CPUS_PER_TASK", value, 1); }
  ~SlurmVariable() { unsetenv("SLURM_CPUS_PER_TASK"); }
};

// This process on one processor, and whatever it starts meanwhile.
class OneProcessor {
 public:
  OneProcessor() {
    sched_getaffinity(0, sizeof before_, &before_);
    int first = 0;
    while (!CPU_ISSET(first, &before_)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OneProcessor() { sched_setaffinity(0, sizeof before_, &before_); }

 private:
  cpu_set_t before_;
};

TEST(ThreadCount, IsWhatWasAskedFor) {
  const SlurmVariable slurm("3");
  EXPECT_EQ(choose_thread_count(5), 5);
  EXPECT_EQ(choose_thread_count(max_threads), max_threads);
}

TEST(ThreadCount, ElseWhatSlurmGives) {
  const SlurmVariable slurm("3");
  EXPECT_EQ(choose_thread_count(0), 3);
}

TEST(ThreadCount, ElseWhatTheAffinityMaskHolds) {
  const OneProcessor one;
  EXPECT_EQ(choose_thread_count(0), 1);
}

TEST(ThreadCount, IgnoresWhatSlurmCannotMean) {
  const OneProcessor one;
  for (const char* value : {"", "0", "-2", "2x", " 2", "many", "99999999999999999999", "4097"}) {
    const SlurmVariable slurm(value);
    EXPECT_EQ(choose_thread_count(0), 1) << "SLURM_CPUS_PER_TASK=" << value;
  }
}

TEST(ThreadCount, RefusesImpossibleNumbers) {
  for (const int threads : {-1, max_threads + 1}) {
    try {
      choose_thread_count(threads);
      FAIL() << threads << " threads were accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

void expect_device_threads(const std::string& expected, Environment environment, const std::string& asked = "0") {
  environment.merge(warm_cache());
  const ChildResult result = run_device_child({"info", "", asked}, environment);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(result.value("compute_units"), expected) << result.output;
}

TEST(DeviceThreads, FollowTheAffinityMask) {
  const OneProcessor one;
  expect_device_threads("1", {});
}

TEST(DeviceThreads, FollowSlurm) { expect_device_threads("1", {{"SLURM_CPUS_PER_TASK", "1"}}); }

TEST(DeviceThreads, FollowTheRequestBeforeAllElse) {
  expect_device_threads(
      "3", {{"SLURM_CPUS_PER_TASK", "1"}, {"POCL_MAX_PTHREAD_COUNT", "2"}, {"POCL_CPU_MAX_CU_COUNT", "2"}}, "3");
}

TEST(DeviceThreads, FollowPoclsOwnVariableBeforeSlurm) {
  expect_device_threads(
      "3", {{"SLURM_CPUS_PER_TASK", "1"}, {"POCL_MAX_PTHREAD_COUNT", "3"}, {"POCL_CPU_MAX_CU_COUNT", "3"}});
}

}  // namespace
}  // namespace morphcl
