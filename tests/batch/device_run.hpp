// Batch transforms on the device alone: transform_vertices() lets the host do small ones.
#pragma once

#include "host/device/session_access.hpp"
#include "morphcl/opencl_interop.hpp"
#include "tests/batch/test_batch.hpp"

namespace morphcl::testing {

// A buffer with the values' bytes.
template <class Element>
cl::Buffer buffer_of(const Session& session, const std::vector<Element>& values) {
  if (values.empty()) return cl::Buffer(context_of(session), CL_MEM_READ_WRITE, sizeof(Element));
  return cl::Buffer(context_of(session), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(Element),
                    const_cast<Element*>(values.data()));
}

template <class Real>
VertexBuffers buffers_of(const Session& session, const Batch<Real>& batch) {
  VertexBuffers buffers{batch.layout, {}};
  for (std::size_t i = 0; i < array_count(batch.layout); ++i) buffers.arrays[i] = buffer_of(session, batch.arrays[i]);
  return buffers;
}

inline ChoiceBuffers choice_buffers(const Session&) { return {}; }
inline ChoiceBuffers choice_buffers(const Session& session, const std::vector<std::uint32_t>& index) {
  return IndexBuffer{buffer_of(session, index)};
}
template <class Real>
ChoiceBuffers choice_buffers(const Session& session, const Blend<Real>& blend) {
  return BlendBuffers{buffer_of(session, blend.matrices), buffer_of(session, blend.weights)};
}

template <class Real>
Batch<Real> read_back(const Session& session, const VertexBuffers& buffers, std::size_t count) {
  Batch<Real> batch(buffers.layout, count);
  for (std::size_t i = 0; i < array_count(batch.layout) && count > 0; ++i)
    queue_of(session).enqueueReadBuffer(buffers.arrays[i], CL_TRUE, 0, batch.arrays[i].size() * sizeof(Real),
                                        batch.arrays[i].data());
  return batch;
}

// The device's results for `in`, with the choice that choice_buffers() makes of the rest.
template <class Real, class... Choice>
Batch<Real> run_on_device(Session& session, const Transform<Real>& transform, const Batch<Real>& in,
                          const Choice&... choice) {
  const VertexBuffers out = buffers_of(session, Batch<Real>(in.layout, in.size(), Real{12345}));
  enqueue_transform(session, transform, buffers_of(session, in), out, in.size(), choice_buffers(session, choice...));
  return read_back<Real>(session, out, in.size());
}

}  // namespace morphcl::testing
