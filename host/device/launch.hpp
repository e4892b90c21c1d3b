// Typed kernel launches: launch(queue, kernel, global, local, arguments...).
//
// The arguments are given in the kernel's order: cl::Buffer for pointers to global or constant memory, LocalMemory for
// pointers to local memory, and plain values (cl_int, cl_float, structs shared with the kernel) for the rest. What the
// compiler can see is checked there (no host pointers, no bool, which OpenCL does not pass); the number of arguments
// and their sizes are checked at the call. Errors name the kernel.
#pragma once

#include <fmt/format.h>

#include <type_traits>

#include "host/device/cl_error.hpp"

namespace morphcl {

struct LocalMemory {
  std::size_t bytes;
};

namespace launch_detail {

template <class Argument>
void set_argument(cl::Kernel& kernel, cl_uint index, const Argument& argument) {
  if constexpr (std::is_same_v<Argument, cl::Buffer>) {
    kernel.setArg(index, argument);
  } else if constexpr (std::is_same_v<Argument, LocalMemory>) {
    kernel.setArg(index, cl::Local(argument.bytes));
  } else {
    static_assert(std::is_trivially_copyable_v<Argument> && std::is_standard_layout_v<Argument>,
                  "a kernel takes buffers, local memory and plain values");
    static_assert(!std::is_pointer_v<Argument> && !std::is_same_v<Argument, bool>,
                  "OpenCL passes neither host pointers nor bool");
    kernel.setArg(index, sizeof argument, &argument);
  }
}

// Sets all arguments; Error(internal) if the kernel takes another number of them.
template <class... Arguments>
void set_arguments(cl::Kernel& kernel, const std::string& name, const Arguments&... arguments) {
  const cl_uint expected = kernel.getInfo<CL_KERNEL_NUM_ARGS>();
  if (expected != sizeof...(arguments))
    throw Error(ErrorKind::internal, "",
                fmt::format("kernel {} takes {} arguments, {} were given", name, expected, sizeof...(arguments)));
  cl_uint index = 0;
  (set_argument(kernel, index++, arguments), ...);
}

inline bool is_empty(const cl::NDRange& range) {
  for (cl::size_type dimension = 0; dimension < range.dimensions(); ++dimension)
    if (range[dimension] == 0) return true;
  return false;
}

}  // namespace launch_detail

// Enqueues `kernel` over `global` work-items in groups of `local`, which must divide it; does nothing if `global` is
// empty. Not for two threads with one kernel object at a time: arguments are state of the kernel.
template <class... Arguments>
void launch(const cl::CommandQueue& queue, cl::Kernel& kernel, const cl::NDRange& global, const cl::NDRange& local,
            const Arguments&... arguments) {
  if (launch_detail::is_empty(global)) return;
  const std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
  checked("launch of kernel " + name, [&] {
    launch_detail::set_arguments(kernel, name, arguments...);
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, global, local);
  });
}

}  // namespace morphcl
