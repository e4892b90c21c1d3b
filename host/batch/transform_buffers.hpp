// Batch transforms of vertices that lie in buffers of the device.
#pragma once

#include <array>
#include <type_traits>
#include <variant>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"
#include "host/device/session.hpp"

namespace morphcl {

// One buffer for each array of the layout; each holds at least the vertices that a call is about.
struct VertexBuffers {
  VertexLayout layout;
  std::array<cl::Buffer, 3> arrays;  // the second and third of `separate` alone
};

struct IndexBuffer {
  cl::Buffer index;  // a uint a vertex
};

struct BlendBuffers {
  cl::Buffer matrices;  // four ushorts a vertex
  cl::Buffer weights;   // four reals a vertex
};

using ChoiceBuffers = std::variant<std::monostate, IndexBuffer, BlendBuffers>;

// Error(no_device) if the device cannot compute with Real: double without cl_khr_fp64.
template <class Real>
void check_precision(const DeviceInfo& device);

// Puts the transform of the first `count` vertices into the session's queue, in order with what is there. `out` may be
// the same buffers as `in`; other overlap is not allowed and not found out. Results bypass the cache where they are too
// many to stay in it and their buffers' memory is aligned to 64 bytes.
// A vertex that asks for a matrix past the last one becomes NaN; the uint in `bad_index`, where it is given, is set to
// 1 if there are any. Error(usage): layouts differ, a buffer is too small, several matrices without a choice, a blend
// of normals. Error(no_device, internal): check_precision(), or the device failed.
template <class Real>
void enqueue_transform(Session& session, const Transform<Real>& transform, const VertexBuffers& in,
                       const VertexBuffers& out, std::size_t count, const ChoiceBuffers& choice = {},
                       cl::Buffer bad_index = {});

}  // namespace morphcl
