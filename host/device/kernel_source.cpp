#include "host/device/kernel_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "morphcl/error.hpp"

namespace morphcl {

const KernelSource& kernel_source(std::string_view stage) { return kernel_source(stage, kernel_sources()); }

const KernelSource& kernel_source(std::string_view stage, const std::vector<KernelSource>& sources) {
  const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& s) { return s.stage == stage; });
  if (found != sources.end()) return *found;
  throw Error(ErrorKind::internal, "", fmt::format("no kernel program \"{}\" is embedded in this build", stage));
}

const KernelSignature& signature_of(const KernelSource& source, std::string_view kernel) {
  const auto& kernels = source.kernels;
  const auto found = std::find_if(kernels.begin(), kernels.end(), [&](const auto& k) { return k.name == kernel; });
  if (found != kernels.end()) return *found;
  throw Error(ErrorKind::internal, "", fmt::format("{} has no kernel {}", source.file, kernel));
}

}  // namespace morphcl
