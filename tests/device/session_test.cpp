// Finding and choosing devices, and what is said when there is none.
#include "host/device/session_access.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <csignal>

#include "morphcl/error.hpp"
#include "tests/device/run_device_child.hpp"
#include "tests/device/shared_session.hpp"

namespace morphcl {
namespace {

using testing::ChildResult;
using testing::run_device_child;
using testing::shared_session;

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

TEST(Session, OpensTheFirstCpuDeviceByDefault) {
  const auto devices = list_devices();
  ASSERT_FALSE(devices.empty());
  const auto cpu = std::find_if(devices.begin(), devices.end(), [](const DeviceInfo& info) { return info.is_cpu; });
  EXPECT_EQ(shared_session().info().index, cpu != devices.end() ? cpu->index : 0);
}

void do_nothing(int) {}

TEST(Session, LeavesTheSignalHandlersOfTheProgramInPlace) {
  constexpr int numbers[] = {SIGUSR1, SIGUSR2, SIGTERM, SIGINT, SIGHUP, SIGXFSZ, SIGSEGV, SIGABRT};
  for (const int number : numbers) std::signal(number, do_nothing);
  ASSERT_FALSE(list_devices().empty());
  for (const int number : numbers) EXPECT_EQ(std::signal(number, SIG_DFL), do_nothing) << number;
}

TEST(Session, ListsDevicesWithTheirLimits) {
  int index = 0;
  for (const DeviceInfo& info : list_devices()) {
    EXPECT_EQ(info.index, index++);
    EXPECT_NE(info.name, "");
    EXPECT_NE(info.platform, "");
    EXPECT_NE(info.driver_version, "");
    EXPECT_GE(info.compute_units, 1u);
    EXPECT_GE(info.max_allocation, std::size_t{1} << 20);
    EXPECT_GE(info.global_memory, info.max_allocation);
    EXPECT_GE(info.local_memory, std::size_t{1} << 14);
  }
}

TEST(Session, OpensByIndexAndByPartOfAName) {
  const DeviceInfo first = list_devices().front();
  SessionOptions options;
  for (const std::string& wanted : {std::string("0"), first.name, upper_case(first.name.substr(1, 6))}) {
    options.device = wanted;
    EXPECT_EQ(Session::open(options)->info().name, first.name) << "--device " << wanted;
  }
}

TEST(Session, UnknownDeviceListsThoseThereAre) {
  const DeviceInfo first = list_devices().front();
  for (const std::string wanted : {"no such device", "999", "99999999999999999999999", "-1"}) {
    SessionOptions options;
    options.device = wanted;
    try {
      Session::open(options);
      FAIL() << "--device " << wanted << " was opened";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::no_device);
      EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(first.name), std::string::npos) << error.what();
    }
  }
}

TEST(Session, WithoutAnyDeviceThePackageIsNamed) {
  for (const char* vendors : {"/nonexistent", "/nonexistent/libnone.so"}) {
    const ChildResult result = run_device_child({"info"}, {{"OCL_ICD_VENDORS", vendors}, {"MORPHCL_CACHE_DIR", "-"}});
    EXPECT_EQ(result.exit_code, 69) << result.output;
    EXPECT_NE(result.value("error").find("pocl-opencl-icd"), std::string::npos) << result.output;
  }
}

TEST(Session, UnknownProgramsAndKernelsAreNamed) {
  const auto expect_named = [](const char* stage, const char* kernel, const char* named) {
    try {
      kernel_of(shared_session(), kernel_source(stage), kernel);
      FAIL() << stage << "/" << kernel << " was found";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::internal);
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  expect_named("no_such_stage", "kernel", "no_such_stage");
  expect_named("self_test", "no_such_kernel", "kernels/self_test.cl has no kernel no_such_kernel");
}

TEST(Session, KernelObjectsAreNotShared) {
  const KernelSource& source = kernel_source("self_test");
  const Kernel one = kernel_of(shared_session(), source, "self_test_scalar");
  const Kernel other = kernel_of(shared_session(), source, "self_test_scalar");
  EXPECT_NE(one.object()(), other.object()());
}

}  // namespace
}  // namespace morphcl
