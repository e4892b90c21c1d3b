#include "host/device/device_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <optional>

#include "host/device/cache_dir.hpp"
#include "host/device/cl_error.hpp"
#include "host/device/prepare_process.hpp"
#include "host/lower_case.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

DeviceInfo describe(const cl::Device& device, const cl::Platform& platform, int index) {
  DeviceInfo info;
  info.index = index;
  info.name = printable(device.getInfo<CL_DEVICE_NAME>());
  info.vendor = printable(device.getInfo<CL_DEVICE_VENDOR>());
  info.driver_version = printable(device.getInfo<CL_DRIVER_VERSION>());
  info.platform = printable(platform.getInfo<CL_PLATFORM_NAME>() + ", " + platform.getInfo<CL_PLATFORM_VERSION>());
  info.is_cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
  info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  info.global_memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  info.local_memory = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
  info.fp64 = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
  return info;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
  std::vector<cl::Device> devices;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
  } catch (const cl::Error&) {
    devices.clear();  // a platform without devices, or a broken one, must not hide the others
  }
  return devices;
}

std::optional<std::size_t> as_index(std::string_view text) {
  std::size_t index = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (text.empty() || failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

const FoundDevice* match(const std::vector<FoundDevice>& devices, std::string_view wanted) {
  if (wanted.empty()) {
    const auto cpu = std::find_if(devices.begin(), devices.end(), [](const auto& found) { return found.info.is_cpu; });
    return cpu != devices.end() ? &*cpu : &devices.front();
  }
  if (const auto index = as_index(wanted)) return *index < devices.size() ? &devices[*index] : nullptr;
  const std::string part = lower_case(wanted);
  const auto named = std::find_if(devices.begin(), devices.end(), [&](const auto& found) {
    return lower_case(found.info.name).find(part) != std::string::npos;
  });
  return named != devices.end() ? &*named : nullptr;
}

// "installed", or "found with POCL_DEVICES=gpu": what the user has set that hides devices.
std::string installed_or_chosen() {
  std::string set;
  for (const char* variable : {"POCL_DEVICES", "POCL_BUILDING", "OCL_ICD_VENDORS", "OCL_ICD_FILENAMES"})
    if (const char* value = std::getenv(variable))
      set += fmt::format("{}{}={}", set.empty() ? "found with " : ", ", variable, value);
  return set.empty() ? "installed" : set;
}

// LLVM, which PoCL brings, puts handlers of its own over those of the program when it is asked for devices: USR1 would
// do nothing, and a file size limit end the process. While this lives that is allowed. The one for SIGFPE stays: PoCL
// needs it for kernels that divide integers by zero.
class KeptSignalHandlers {
 public:
  KeptSignalHandlers() {
    for (int number = 1; number < NSIG; ++number)
      known_[static_cast<std::size_t>(number)] =
          sigaction(number, nullptr, &before_[static_cast<std::size_t>(number)]) == 0;
  }
  ~KeptSignalHandlers() {
    for (int number = 1; number < NSIG; ++number)
      if (known_[static_cast<std::size_t>(number)] && number != SIGFPE)
        sigaction(number, &before_[static_cast<std::size_t>(number)], nullptr);
  }
  KeptSignalHandlers(const KeptSignalHandlers&) = delete;
  KeptSignalHandlers& operator=(const KeptSignalHandlers&) = delete;

 private:
  std::array<struct sigaction, NSIG> before_ = {};
  std::array<bool, NSIG> known_ = {};
};

}  // namespace

std::vector<FoundDevice> find_devices(const std::string& cache_dir) {
  ensure_process_prepared();
  place_pocl_cache(choose_cache_dir(cache_dir));
  const KeptSignalHandlers kept;
  std::vector<cl::Platform> platforms;
  std::string reason = "none is " + installed_or_chosen();
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error& error) {
    platforms.clear();
    if (error.err() != CL_PLATFORM_NOT_FOUND_KHR) reason = cl_code_name(error.err());
  }
  std::vector<FoundDevice> found;
  for (const cl::Platform& platform : platforms)
    for (const cl::Device& device : devices_of(platform)) {
      try {
        found.push_back({device, platform, describe(device, platform, static_cast<int>(found.size()))});
      } catch (const cl::Error& error) {
        reason = cl_code_name(error.err());
      }
    }
  if (found.empty()) throw no_usable_device(reason);
  return found;
}

const FoundDevice& choose_device(const std::vector<FoundDevice>& devices, std::string_view wanted) {
  if (const FoundDevice* device = match(devices, wanted)) return *device;
  std::string names;
  for (const FoundDevice& found : devices)
    names += fmt::format("{}{} \"{}\"", names.empty() ? "" : ", ", found.info.index, found.info.name);
  throw Error(ErrorKind::no_device, "",
              fmt::format("no OpenCL device matches \"{}\"; there are: {}; `reference` needs none", wanted, names));
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> infos;
  for (FoundDevice& found : find_devices("")) infos.push_back(std::move(found.info));
  return infos;
}

}  // namespace morphcl
