#include "host/device/build_options.hpp"

namespace morphcl {

std::string build_options(const cl::Device& device, const cl::Platform& platform) {
  // Without warnings: PoCL prints their number on stderr, on processors whose vectors are narrower than the kernels'.
  std::string options = "-cl-std=CL1.2 -w";
  if (device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT)
    options += " -cl-fp32-correctly-rounded-divide-sqrt";
  if (platform.getInfo<CL_PLATFORM_NAME>() == "Portable Computing Language") options += " -DMORPHCL_POCL";
  return options;
}

}  // namespace morphcl
