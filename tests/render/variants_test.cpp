// The same bits with one thread and with two, whatever a picture is asked for, and with every kernel library that this
// processor can run: PoCL's libraries stand in for several kinds of processor.
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

std::string output_of(const std::vector<std::string>& command, const Environment& environment) {
  // Of this process's variables the program sees PATH, HOME and TMPDIR only: none may choose a kernel library.
  const test_support::ProcessResult result =
      test_support::run_process(command, {.environment = environment,
                                          .inherits_environment = false,
                                          .standard_error = test_support::StandardError::with_stdout,
                                          .limit = std::chrono::minutes(20)});
  EXPECT_EQ(result.code, 0) << result.out;
  return result.out;
}

// Of all test scenes, with the usual options.
std::vector<std::string> frames() { return {MORPHCL_FRAME_HASHES, "150", "100"}; }
// Of three scenes, with options that have every value, every pair of values, or all combinations.
std::vector<std::string> options(const char* combinations) { return {MORPHCL_OPTION_HASHES, combinations}; }

std::string by_reference(std::vector<std::string> command) {
  command.emplace_back("reference");
  return output_of(command, {});
}

void expect_reference_with_one_thread_and_with_two(const std::vector<std::string>& command, int pictures) {
  const std::string reference = by_reference(command);
  EXPECT_GT(std::count(reference.begin(), reference.end(), '\n'), pictures);
  for (const char* threads : {"1", "2"}) {
    Environment environment = testing::warm_cache();
    environment["SLURM_CPUS_PER_TASK"] = threads;
    EXPECT_EQ(output_of(command, environment), reference) << threads;
  }
}

TEST(FrameHashes, AreThoseOfTheReferenceWithOneThreadAndWithTwo) {
  expect_reference_with_one_thread_and_with_two(frames(), 25);
}

TEST(FrameHashes, OfEveryPairOfOptionsAreThoseOfTheReference) {
  expect_reference_with_one_thread_and_with_two(options(testing::long_tests() ? "all" : "pairs"), 80);
}

TEST(FrameHashes, AreTheSameForEveryKernelLibrary) {
  std::vector<std::vector<std::string>> commands = {frames()};
  if (testing::long_tests()) commands.push_back(options("values"));
  for (const std::vector<std::string>& command : commands) {
    const std::string reference = by_reference(command);
    for (const std::string& library : testing::kernel_libraries_that_run_here()) {
      const TemporaryFolder cache;  // of its own: PoCL's must not be shared between kernel libraries
      EXPECT_EQ(output_of(command, {{"MORPHCL_CACHE_DIR", cache.path().string()}, {"POCL_KERNELLIB_NAME", library}}),
                reference)
          << library;
    }
  }
}

}  // namespace
}  // namespace morphcl::test
