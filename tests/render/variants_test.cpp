// The same bits with one thread and with two, and with every kernel library that this processor can run: PoCL's
// libraries stand in for several kinds of processor.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/device/kernel_libraries.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

using test_support::Environment;
using test_support::TemporaryFolder;

std::string frame_hashes(Environment environment, const TemporaryFolder& cache,
                         const std::vector<std::string>& extra = {}) {
  environment["MORPHCL_CACHE_DIR"] = (cache / "morphcl").string();
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

TEST(FrameHashes, AreThoseOfTheReferenceWithOneThreadAndWithTwo) {
  const TemporaryFolder cache;
  const std::string reference = frame_hashes({}, cache, {"reference"});
  EXPECT_GT(std::count(reference.begin(), reference.end(), '\n'), 25);
  EXPECT_EQ(frame_hashes({{"SLURM_CPUS_PER_TASK", "1"}}, cache), reference);
  EXPECT_EQ(frame_hashes({{"SLURM_CPUS_PER_TASK", "2"}}, cache), reference);
}

TEST(FrameHashes, AreTheSameForEveryKernelLibrary) {
  const std::string reference = frame_hashes({}, TemporaryFolder(), {"reference"});
  for (const std::string& library : testing::kernel_libraries_that_run_here()) {
    const TemporaryFolder cache;  // of its own: PoCL's must not be shared between kernel libraries
    EXPECT_EQ(frame_hashes({{"POCL_KERNELLIB_NAME", library}}, cache), reference) << library;
  }
}

}  // namespace
}  // namespace morphcl::test
