// OpenCL's numbers as lines that say what to do.
#include "host/device/cl_error.hpp"

#include <gtest/gtest.h>

namespace morphcl {
namespace {

TEST(ClError, NamesCodes) {
  EXPECT_EQ(cl_code_name(CL_OUT_OF_RESOURCES), "CL_OUT_OF_RESOURCES");
  EXPECT_EQ(cl_code_name(CL_INVALID_PROPERTY), "CL_INVALID_PROPERTY");
  EXPECT_EQ(cl_code_name(-1001), "CL_PLATFORM_NOT_FOUND_KHR");
  EXPECT_EQ(cl_code_name(-12345), "unknown code -12345");
}

TEST(ClError, TellsTaskCallAndCode) {
  const Error error =
      device_error(cl::Error(CL_INVALID_KERNEL_ARGS, "clEnqueueNDRangeKernel"), "launch of kernel shade");
  EXPECT_EQ(error.kind(), ErrorKind::internal);
  EXPECT_TRUE(std::string(error.what())
                  .starts_with("launch of kernel shade: OpenCL call clEnqueueNDRangeKernel failed "
                               "with CL_INVALID_KERNEL_ARGS (-52)"))
      << error.what();
}

TEST(ClError, MemoryAndLostDevicesAreNotDefects) {
  for (const cl_int code : {CL_OUT_OF_RESOURCES, CL_OUT_OF_HOST_MEMORY, CL_MEM_OBJECT_ALLOCATION_FAILURE,
                            CL_DEVICE_NOT_AVAILABLE, CL_DEVICE_NOT_FOUND})
    EXPECT_EQ(device_error(cl::Error(code, "clCall"), "task").kind(), ErrorKind::no_device) << code;
}

TEST(ClError, CheckedPassesResultsAndOtherErrorsThrough) {
  EXPECT_EQ(checked("task", [] { return 42; }), 42);
  EXPECT_THROW(checked("task", [] { throw Error(ErrorKind::bad_input, "file", "wrong"); }), Error);
  EXPECT_THROW(checked("task", [] { throw cl::Error(CL_INVALID_VALUE, "clCall"); }), Error);
}

}  // namespace
}  // namespace morphcl
