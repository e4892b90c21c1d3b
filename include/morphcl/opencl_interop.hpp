// Work with OpenCL beside the library: a session's context and queue, and batch transforms of buffers of the device.
//
// The only header that shows OpenCL; morphcl.hpp leaves it out. It includes CL/opencl.hpp with the settings that the
// library was built with: whoever includes that one elsewhere in the same program states the same three macros.
#pragma once

#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>
#include <array>
#include <cstddef>
#include <variant>

#include "morphcl/session.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

enum class VertexLayout;  // this and Transform: batch.hpp
template <class Real>
class Transform;

// Both belong to the session.
const cl::Context& context_of(const Session& session);
const cl::CommandQueue& queue_of(const Session& session);  // in order; shared with the library's own work

// One buffer for each array of the layout; each holds at least the vertices that a call is about.
struct VertexBuffers {
  VertexLayout layout;
  std::array<cl::Buffer, 3> arrays;  // the second and third of `separate` alone
};

struct IndexBuffer {
  cl::Buffer index;  // a uint a vertex: its matrix
};

struct BlendBuffers {
  cl::Buffer matrices;  // four ushorts a vertex
  cl::Buffer weights;   // four reals a vertex
};

using ChoiceBuffers = std::variant<std::monostate, IndexBuffer, BlendBuffers>;

// Error(no_device) if the device cannot compute with Real: double without cl_khr_fp64.
template <class Real>
void check_precision(const DeviceInfo& device);

// Puts the transform of the first `count` vertices into the session's queue, in order with what is there, and returns
// before it is done; the transform is copied. Buffers are of the session's context. `out` may be the same buffers as
// `in`; other overlap is not allowed and not found out. Results bypass the cache where they are too many to stay in it
// and their buffers' memory is aligned to 64 bytes. A vertex that asks for a matrix past the last one becomes NaN; the
// uint in `bad_index`, where it is given and 0 before, is set to 1 if there are any. Error(usage): layouts differ, a
// buffer is too small, several matrices without a choice, a blend of normals. Error(no_device, internal):
// check_precision(), or the device failed.
template <class Real>
[[gnu::visibility("default")]] void enqueue_transform(Session& session, const Transform<Real>& transform,
                                                      const VertexBuffers& in, const VertexBuffers& out,
                                                      std::size_t count, const ChoiceBuffers& choice = {},
                                                      cl::Buffer bad_index = {});

}  // namespace morphcl
#pragma GCC visibility pop
