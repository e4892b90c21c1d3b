// PoCL's kernel libraries stand in for several kinds of processor: all must give the same bits.
#include <gtest/gtest.h>

#include <vector>

#include "tests/device/kernel_libraries.hpp"
#include "tests/device/run_device_child.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::testing {
namespace {

TEST(KernelLibraries, GiveTheSameBits) {
  const std::vector<std::string> command = {"transform", "5000", "33"};
  const auto hash = [&](const char* library) {
    const test_support::TemporaryFolder cache;  // whether PoCL tells libraries apart in its cache is not documented
    test_support::Environment environment = {{"MORPHCL_CACHE_DIR", "-"}, {"POCL_CACHE_DIR", cache.path().string()}};
    if (library) environment["POCL_KERNELLIB_NAME"] = library;
    const ChildResult result = run_device_child(command, environment);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.value("hash");
  };
  const std::string native = hash(nullptr);
  ASSERT_NE(native, "");
  for (const std::string& library : kernel_libraries_that_run_here())
    EXPECT_EQ(hash(library.c_str()), native) << library;
}

}  // namespace
}  // namespace morphcl::testing
