// The kernels under Oclgrind: a second OpenCL implementation, which also checks every access.
#include <gtest/gtest.h>

#include "tests/device/run_device_child.hpp"
#include "tests/device/warm_cache.hpp"

namespace morphcl::testing {
namespace {

ChildResult run_checked(const std::vector<std::string>& arguments) {
  std::vector<std::string> command = {MORPHCL_OCLGRIND_CLEAN};
  for (const std::string& word : device_child_command(arguments)) command.push_back(word);
  return run_child(command, {});
}

TEST(Oclgrind, SelfTestIsCleanAndIdentical) {
  const ChildResult result = run_checked({"info"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.value("name").find("Oclgrind"), std::string::npos) << result.output;
  EXPECT_EQ(result.value("verdict"), "identical");
}

TEST(Oclgrind, TransformsAreCleanAndGiveTheSameBits) {
  const std::vector<std::string> transforms = {"transform", "1", "15", "16", "17", "100"};
  const ChildResult result = run_checked(transforms);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(result.value("hash"), run_device_child(transforms, warm_cache()).value("hash"));
}

TEST(Oclgrind, AStrayWriteIsReported) {
  const ChildResult result = run_checked({"stray_write"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.output.find("Invalid write"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace morphcl::testing
