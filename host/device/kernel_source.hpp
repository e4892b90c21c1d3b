// The text of kernels/*.cl, embedded by the build with its headers in place.
#pragma once

#include <string>
#include <vector>

namespace morphcl {

struct KernelSource {
  std::string stage;  // the file's stem
  std::string text;
};

const std::vector<KernelSource>& kernel_sources();  // sorted by stage

}  // namespace morphcl
