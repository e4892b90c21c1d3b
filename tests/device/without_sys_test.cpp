// Where /sys is not mounted PoCL takes its process down; the user must get one line and the exit code instead.
#include <gtest/gtest.h>

#include "tests/device/run_device_child.hpp"

namespace morphcl::testing {
namespace {

TEST(WithoutSys, TheReasonAndTheRemedyAreSaidInOneLine) {
  // Every mount inside is gone with the process.
  const std::string script = "mount -t tmpfs none /sys && exec \"$0\" info";
  const ChildResult result =
      run_child({"unshare", "-rm", "sh", "-c", script, MORPHCL_DEVICE_CHILD}, {{"MORPHCL_CACHE_DIR", "-"}});
  EXPECT_EQ(result.exit_code, 69) << result.output;
  EXPECT_NE(result.value("error").find("/sys"), std::string::npos) << result.output;
  EXPECT_EQ(result.output, "error " + result.value("error") + "\n");
}

}  // namespace
}  // namespace morphcl::testing
