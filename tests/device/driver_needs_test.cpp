// What PoCL needs of a process, and what is said where it is missing.
#include "host/device/driver_needs.hpp"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>

#include "host/thread_count.hpp"
#include "morphcl/error.hpp"
#include "morphcl/session.hpp"
#include "tests/device/run_device_child.hpp"
#include "tests/device/warm_cache.hpp"
#include "tests/support/exit_code_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using test_support::Environment;
using test_support::exit_code_of;
using test_support::TemporaryFolder;
using testing::ChildResult;
using testing::run_child;

void limit(decltype(RLIMIT_FSIZE) resource, rlim_t value) {
  const rlimit both = {value, value};
  setrlimit(resource, &both);
}

TEST(DriverNeeds, FoldersThatAreNoUseSayWhy) {
  const TemporaryFolder folder;
  EXPECT_EQ(folder_trouble(folder.path()), "");
  EXPECT_EQ(folder_trouble(folder / "made"), "");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "made"));
  folder.write("file", "");
  EXPECT_NE(folder_trouble(folder / "file"), "");
  EXPECT_NE(folder_trouble(folder / "file/below"), "");
  EXPECT_NE(folder_trouble("/proc/none"), "");
  EXPECT_EQ(folder.names(), (std::set<std::string>{"file", "made"}));
}

// Only root may mount.
TEST(DriverNeeds, AFullFolderAndOneWithoutExecutionAreNoUse) {
  for (const auto& [options, flags, word] :
       {std::tuple{"size=1m", 0ul, "No space"}, {"size=9m", 0ul + MS_NOEXEC, "noexec"}}) {
    const TemporaryFolder folder;
    if (mount("none", folder.path().c_str(), "tmpfs", flags, options) != 0) return;
    EXPECT_NE(folder_trouble(folder.path()).find(word), std::string::npos) << folder_trouble(folder.path());
    umount(folder.path().c_str());
  }
}

TEST(DriverNeeds, LimitsOfTheProcess) {
  EXPECT_EQ(exit_code_of(check_driver_limits), 0);
  EXPECT_EQ(exit_code_of([] {
              limit(RLIMIT_STACK, 64 << 10);
              check_driver_limits();
            }),
            69);
  EXPECT_EQ(exit_code_of([] {
              limit(RLIMIT_STACK, 256 << 10);
              check_driver_limits();
              check_stack_limit(128 << 10);
            }),
            0);
  EXPECT_EQ(exit_code_of([] {
              limit(RLIMIT_STACK, 256 << 10);
              check_stack_limit(129 << 10);
            }),
            69);
  EXPECT_EQ(exit_code_of([] {
              limit(RLIMIT_FSIZE, 16 << 10);
              check_driver_limits();
            }),
            69);
}

TEST(DriverNeeds, AsManyThreadsAsTheSystemStarts) {
  EXPECT_EQ(startable_threads(3), 3);
  if (geteuid() != 0) return;  // the limit is that of a user, who has to have no other process
  const auto startable = [](rlim_t processes) {
    return exit_code_of([processes] {
      limit(RLIMIT_NPROC, processes);
      if (setuid(1'000'000 + getpid()) != 0) _exit(1);
      _exit(100 + startable_threads(9));
    });
  };
  EXPECT_EQ(startable(1 + 4 + 2), 102);
  EXPECT_EQ(startable(1 + 4 + 20), 109);
  EXPECT_EQ(startable(1 + 4), 69);
}

class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name_); }

 private:
  const char* name_;
};

TEST(DriverNeeds, NumbersThatPoclCrashesOnAreRefusedByName) {
  for (const char* name : {"POCL_MAX_PTHREAD_COUNT", "POCL_CPU_MAX_CU_COUNT", "POCL_MAX_WORK_GROUP_SIZE"}) {
    for (const char* value : {"-3", "0", "4 ", "many", "1e3", "99999999999999999999"}) {
      const Variable variable(name, value);
      try {
        prepare_process(0);
        ADD_FAILURE() << name << "=" << value;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_EQ(error.place(), name);
        EXPECT_NE(error.message().find(value), std::string::npos);
      }
    }
    const Variable empty(name, "");
    check_driver_variables();
    EXPECT_EQ(std::getenv(name), nullptr);
  }
  const Variable large("POCL_MAX_PTHREAD_COUNT", std::to_string(max_threads + 1).c_str());
  EXPECT_THROW(check_driver_variables(), Error);
}

// Only what the user told both of them is overruled.
TEST(DriverNeeds, WhatIsAskedForOverrulesAWrongVariable) {
  const Variable variable("POCL_MAX_PTHREAD_COUNT", "-3");
  EXPECT_EQ(prepare_process(1), 1);
  EXPECT_STREQ(std::getenv("POCL_MAX_PTHREAD_COUNT"), "1");
}

TEST(DriverNeeds, WithoutALinkerIsSaid) {
  const std::string before = std::getenv("PATH");
  check_linker();
  setenv("PATH", "/nonexistent:", 1);
  EXPECT_THROW(check_linker(), Error);
  setenv("PATH", before.c_str(), 1);
}

// One line, whatever the driver would have printed.
void expect_refusal(const ChildResult& result, const std::string& part) {
  EXPECT_EQ(result.exit_code, 69) << result.output;
  EXPECT_NE(result.value("error").find(part), std::string::npos) << result.output;
  EXPECT_EQ(test_support::lines_of(result.output).back(), "error " + result.value("error"));
  EXPECT_LE(test_support::lines_of(result.output).size(), 2u) << result.output;  // the number of threads before it
}

TEST(DriverNeeds, AProcessIsRefusedInOneLineBeforeTheDriverAborts) {
  const Environment none = {{"MORPHCL_CACHE_DIR", "-"}};
  Environment no_linker = none;
  no_linker["PATH"] = "/nonexistent";
  expect_refusal(testing::run_device_child({"info"}, no_linker), "ld");
  expect_refusal(run_child({"sh", "-c", "ulimit -s 64; exec \"$0\" info", MORPHCL_DEVICE_CHILD}, none), "ulimit -s");
  expect_refusal(run_child({"sh", "-c", "ulimit -f 16; exec \"$0\" info", MORPHCL_DEVICE_CHILD}, none), "ulimit -f");
  Environment cache = none;
  cache["POCL_CACHE_DIR"] = "/proc/none";
  expect_refusal(testing::run_device_child({"info"}, cache), "POCL_CACHE_DIR");
}

TEST(DriverNeeds, AnotherFolderIsTakenWhereTheNamedOneIsFull) {
  const TemporaryFolder folder;
  if (mount("none", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0) return;
  Environment environment = testing::warm_cache();
  environment["TMPDIR"] = folder.path().string();
  const ChildResult result = testing::run_device_child({"info"}, environment);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_TRUE(folder.names().empty());
  umount(folder.path().c_str());
}

}  // namespace
}  // namespace morphcl
