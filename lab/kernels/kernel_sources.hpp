// The programs of lab/kernels, embedded by the build.
#pragma once

#include "host/device/kernel_source.hpp"

namespace morphcl::accuracy {

const std::vector<KernelSource>& lab_kernel_sources();  // sorted by stage

}  // namespace morphcl::accuracy
