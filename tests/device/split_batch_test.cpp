// Batches whose arrays are larger than the device's largest allocation.
#include <gtest/gtest.h>

#include "tests/device/run_device_child.hpp"
#include "tests/device/warm_cache.hpp"

namespace morphcl::testing {
namespace {

TEST(SplitBatch, ArraysBeyondTheLargestAllocationAreTransformedInParts) {
  test_support::Environment environment = warm_cache();
  environment["POCL_MEMORY_LIMIT"] = "1";  // GiB, of which PoCL gives a quarter to one buffer
  constexpr std::size_t count = 23'000'001;
  const ChildResult result = run_device_child({"split", std::to_string(count)}, environment);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_LT(std::stoul(result.value("largest_allocation")), count * 3 * sizeof(float));
  EXPECT_EQ(result.value("different"), "0");
}

}  // namespace
}  // namespace morphcl::testing
