#include "host/device/driver_needs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <latch>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "host/device/prepare_process.hpp"
#include "host/thread_count.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace fs = std::filesystem;

namespace {

// Cold compilation, which takes most, works with 128 kB and crashes with 64.
constexpr rlim_t min_stack_bytes = rlim_t{128} << 10;
// What a job needs beside PoCL's threads: one that plans, one that writes, one that stores what was compiled, and the
// linker's process.
constexpr int threads_of_a_job = 4;

std::string why(int error) { return std::strerror(error); }

rlim_t limit_of(decltype(RLIMIT_FSIZE) resource) {
  rlimit limit = {};
  return getrlimit(resource, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

// Takes the room, so that quotas and full disks are found whatever the file system says of itself.
int try_to_write(const fs::path& folder, std::size_t bytes) {
  // Without a name, so that nothing is left of it whenever the process is killed; not all file systems have that.
  int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0) {
    std::string name = (folder / "morphcl-room-XXXXXX").string();
    file = mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) return errno;
    unlink(name.c_str());
  }
  int failure = EINTR;
  while (failure == EINTR) failure = posix_fallocate(file, 0, static_cast<off_t>(bytes));
  close(file);
  return failure;
}

Error limit_too_low(std::string_view what, std::string_view option, rlim_t limit, rlim_t needed) {
  return Error(
      ErrorKind::no_device, "",
      fmt::format("the {} of this process is {} kB, and the OpenCL driver needs {}; raise it (ulimit {}), or use "
                  "--device reference",
                  what, limit >> 10, needed >> 10, option));
}

void check_number(const char* variable, long long min, long long max, const char* what) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  const std::string_view text = value;
  if (text.empty()) {
    unsetenv(variable);
    return;
  }
  long long number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size() || number < min || number > max)
    throw Error(ErrorKind::usage, variable,
                fmt::format("'{}' is no number of {}; {} to {}, or unset it", text.substr(0, 40), what, min, max));
}

}  // namespace

std::string folder_trouble(const fs::path& folder) {
  if (folder.empty()) return "there is no such folder";
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return failure.message();
  struct statvfs system = {};
  if (statvfs(folder.c_str(), &system) != 0) return why(errno);
  if ((system.f_flag & ST_NOEXEC) != 0) return "it is mounted so that nothing in it can be executed (noexec)";
  if (system.f_blocks != 0 && system.f_frsize != 0 && system.f_bavail < driver_folder_bytes / system.f_frsize)
    return why(ENOSPC);
  const int error =
      try_to_write(folder, static_cast<std::size_t>(std::min<rlim_t>(limit_of(RLIMIT_FSIZE), driver_folder_bytes)));
  return error != 0 ? why(error) : "";
}

void check_driver_variables() {
  for (const char* variable : pocl_thread_variables) check_number(variable, 1, max_threads, "threads");
  check_number("POCL_MAX_WORK_GROUP_SIZE", 1, 1 << 20, "work items");
}

int startable_threads(int wanted) {
  std::latch all_tried(1);
  std::vector<std::jthread> threads;
  std::string reason;
  try {
    while (static_cast<int>(threads.size()) < wanted + threads_of_a_job)
      threads.emplace_back([&all_tried] { all_tried.wait(); });
  } catch (const std::system_error& error) {
    reason = error.code().message();
  }
  all_tried.count_down();
  const int started = static_cast<int>(threads.size());
  threads.clear();  // a jthread joins when it goes
  if (started > threads_of_a_job) return std::min(wanted, started - threads_of_a_job);
  throw Error(ErrorKind::no_device, "",
              fmt::format("{} threads can be started here, and {} are needed: {}; raise the limit of processes (ulimit "
                          "-u, pids.max) or of memory (ulimit -v), or use --device reference",
                          started, threads_of_a_job + 1, reason));
}

void check_stack_limit(std::size_t kernel_bytes) {
  const rlim_t needed = min_stack_bytes + kernel_bytes;
  if (const rlim_t stack = limit_of(RLIMIT_STACK); stack < needed)
    throw limit_too_low("stack limit", "-s", stack, needed);
}

void check_driver_limits() {
  check_stack_limit(0);
  if (const rlim_t file = limit_of(RLIMIT_FSIZE); file < driver_file_bytes)
    throw limit_too_low("file size limit", "-f", file, driver_file_bytes);
}

void check_linker() {
  const char* variable = std::getenv("PATH");
  std::istringstream path(variable != nullptr ? variable : "/bin:/usr/bin");
  for (std::string folder; std::getline(path, folder, ':');)
    if (access(((folder.empty() ? fs::path(".") : fs::path(folder)) / "ld").c_str(), X_OK) == 0) return;
  throw no_usable_device("its compiler finds no linker, `ld` of the package binutils, in PATH",
                         "add its folder to PATH, or use --device reference");
}

}  // namespace morphcl
