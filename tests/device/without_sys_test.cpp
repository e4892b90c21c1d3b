// Where /sys is not mounted PoCL takes its process down; the user must get one line and the exit code instead.
#include <gtest/gtest.h>

#include "tests/device/child_process.hpp"

namespace morphcl::testing {
namespace {

TEST(WithoutSys, TheReasonAndTheRemedyAreSaidInOneLine) {
  // Every mount inside is gone with the process.
  const std::string script = "mount -t tmpfs none /sys && exec \"$0\" info";
  ChildProcess child({"unshare", "-rm", "sh", "-c", script, MORPHCL_DEVICE_CHILD}, {{"MORPHCL_CACHE_DIR", "-"}});
  const ChildResult result = child.wait();
  EXPECT_EQ(result.exit_code, 69) << result.output;
  EXPECT_NE(result.value("error").find("/sys"), std::string::npos) << result.output;
  EXPECT_EQ(result.output, "error " + result.value("error") + "\n");
}

}  // namespace
}  // namespace morphcl::testing
