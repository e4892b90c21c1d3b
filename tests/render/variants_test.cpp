// The same bits with one thread and with two, and with every kernel library that this processor can run: PoCL's
// libraries stand in for several kinds of processor.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/device/kernel_libraries.hpp"
#include "tests/device/warm_cache.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

using test_support::Environment;
using test_support::TemporaryFolder;

std::string frame_hashes(const Environment& environment, const std::vector<std::string>& extra = {}) {
  std::vector<std::string> command = {MORPHCL_FRAME_HASHES, "150", "100"};
  command.insert(command.end(), extra.begin(), extra.end());
  // Of this process's variables the program sees PATH, HOME and TMPDIR only: none may choose a kernel library.
  const test_support::ProcessResult result =
      test_support::run_process(command, {.environment = environment,
                                          .inherits_environment = false,
                                          .standard_error = test_support::StandardError::with_stdout,
                                          .limit = std::chrono::minutes(20)});
  EXPECT_EQ(result.code, 0) << result.out;
  return result.out;
}

std::string reference_hashes() { return frame_hashes({}, {"reference"}); }

TEST(FrameHashes, AreThoseOfTheReferenceWithOneThreadAndWithTwo) {
  const std::string reference = reference_hashes();
  EXPECT_GT(std::count(reference.begin(), reference.end(), '\n'), 25);
  for (const char* threads : {"1", "2"}) {
    Environment environment = testing::warm_cache();
    environment["SLURM_CPUS_PER_TASK"] = threads;
    EXPECT_EQ(frame_hashes(environment), reference) << threads;
  }
}

TEST(FrameHashes, AreTheSameForEveryKernelLibrary) {
  const std::string reference = reference_hashes();
  for (const std::string& library : testing::kernel_libraries_that_run_here()) {
    const TemporaryFolder cache;  // of its own: PoCL's must not be shared between kernel libraries
    EXPECT_EQ(frame_hashes({{"MORPHCL_CACHE_DIR", cache.path().string()}, {"POCL_KERNELLIB_NAME", library}}), reference)
        << library;
  }
}

}  // namespace
}  // namespace morphcl::test
