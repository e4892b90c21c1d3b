// The OpenCL devices of this machine, and the choice of one of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/device/opencl.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

struct FoundDevice {
  cl::Device device;
  cl::Platform platform;
  DeviceInfo info;
};

// All devices of all platforms, in the installation's order; info.index is the position. Error(no_device) if none. The
// first call in a process starts OpenCL, with PoCL's own cache below choose_cache_dir(cache_dir).
std::vector<FoundDevice> find_devices(const std::string& cache_dir);

// `wanted` as in SessionOptions::device. Error(no_device) that lists the devices if none matches.
const FoundDevice& choose_device(const std::vector<FoundDevice>& devices, std::string_view wanted);

}  // namespace morphcl
