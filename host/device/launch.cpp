#include "host/device/launch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host/device/cl_error.hpp"

namespace morphcl::launch_detail {

namespace {

bool is_empty(const cl::NDRange& range) {
  for (cl::size_type dimension = 0; dimension < range.dimensions(); ++dimension)
    if (range[dimension] == 0) return true;
  return false;
}

Error refused(const Kernel& kernel, const std::string& what) {
  return Error(ErrorKind::internal, "", fmt::format("launch of kernel {}: {}", kernel.name(), what));
}

// Where in the kernel's list each binding belongs.
std::vector<cl_uint> places_of(const Kernel& kernel, std::span<const Binding> bindings) {
  const std::vector<KernelArgument>& arguments = kernel.arguments();
  std::vector<bool> given(arguments.size());
  std::vector<cl_uint> places;
  places.reserve(bindings.size());
  for (const Binding& binding : bindings) {
    const auto found = std::find_if(arguments.begin(), arguments.end(),
                                    [&](const KernelArgument& argument) { return argument.name == binding.name; });
    if (found == arguments.end()) throw refused(kernel, fmt::format("it has no argument \"{}\"", binding.name));
    if (!binding.type.empty() && binding.type != found->type)
      throw refused(kernel, fmt::format("its argument \"{}\" is of type {}, and {} was given", binding.name,
                                        found->type, binding.type));
    const auto place = static_cast<std::size_t>(found - arguments.begin());
    if (given[place]) throw refused(kernel, fmt::format("argument \"{}\" is given twice", binding.name));
    given[place] = true;
    places.push_back(static_cast<cl_uint>(place));
  }
  const auto missing = std::find(given.begin(), given.end(), false);
  if (missing != given.end())
    throw refused(kernel, fmt::format("argument \"{}\" is missing", arguments[missing - given.begin()].name));
  return places;
}

}  // namespace

void launch(const cl::CommandQueue& queue, const Kernel& kernel, const cl::NDRange& offset, const cl::NDRange& global,
            const cl::NDRange& local, std::span<const Binding> bindings) {
  const std::vector<cl_uint> places = places_of(kernel, bindings);
  if (is_empty(global)) return;
  checked("launch of kernel " + kernel.name(), [&] {
    cl::Kernel object = kernel.object();
    for (std::size_t i = 0; i < places.size(); ++i) object.setArg(places[i], bindings[i].bytes, bindings[i].value);
    queue.enqueueNDRangeKernel(object, offset, global, local);
  });
}

}  // namespace morphcl::launch_detail
