// morphcl devices: the OpenCL devices, their self-test verdict and their limits.
#pragma once

namespace morphcl::cli {

struct DevicesOptions {
  int threads = 0;
  bool json = false;
};

int devices_command(const DevicesOptions& options);

}  // namespace morphcl::cli
