#include "host/device/probe.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>

#include "host/device/opencl.hpp"
#include "host/device/prepare_process.hpp"

namespace morphcl {

namespace {

// A cold start of PoCL takes 50 ms; a network home folder or a GPU driver may take seconds.
constexpr std::chrono::seconds probe_limit{20};

bool has_entry_starting_with(const std::filesystem::path& folder, std::string_view prefix) {
  std::error_code failure;
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (entry->path().filename().string().starts_with(prefix)) return true;
  return false;
}

// The folders without which hwloc aborts: processors with a topology; NUMA nodes only where the kernel has them at all.
bool is_sys_complete() {
  std::error_code failure;
  const bool processors = std::filesystem::is_directory("/sys/devices/system/cpu/cpu0/topology", failure);
  const std::filesystem::path nodes = "/sys/devices/system/node";
  return processors && (!std::filesystem::exists(nodes, failure) || has_entry_starting_with(nodes, "node"));
}

// The child: no output, no core file; its exit closes the pipe.
[[noreturn]] void ask_for_devices() {
  const int null = open("/dev/null", O_WRONLY);
  if (null >= 0) {
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
  }
  std::signal(SIGABRT, SIG_DFL);
  cl_uint count = 0;
  cl_platform_id platforms[64];
  if (clGetPlatformIDs(64, platforms, &count) == CL_SUCCESS)
    for (cl_uint i = 0; i < count && i < 64; ++i) {
      cl_uint devices = 0;
      clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 0, nullptr, &devices);
    }
  _exit(0);
}

// True when the other end of the pipe was closed in time.
bool wait_for_close(int pipe_end) {
  const auto deadline = std::chrono::steady_clock::now() + probe_limit;
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    pollfd closed{pipe_end, POLLIN, 0};
    const int ready = poll(&closed, 1, static_cast<int>(std::max<long long>(0, left)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

int wait_for_exit(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return 0;  // reaped elsewhere (SIGCHLD ignored): nothing is known against the installation
  return status;
}

}  // namespace

void probe_installation() {
  if (is_sys_complete()) return;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    ask_for_devices();
  }
  close(ends[1]);
  const bool finished = child > 0 && wait_for_close(ends[0]);
  close(ends[0]);
  if (child < 0) return;
  if (!finished) kill(child, SIGKILL);
  const int status = wait_for_exit(child);
  if (!finished) throw no_usable_device(fmt::format("asking for devices took longer than {} s", probe_limit.count()));
  if (WIFSIGNALED(status))
    throw no_usable_device(
        fmt::format("the OpenCL installation stops with signal {} here because /sys is not mounted", WTERMSIG(status)));
}

}  // namespace morphcl
