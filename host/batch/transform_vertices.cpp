#include <algorithm>
#include <cstdint>
#include <map>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"
#include "host/device/cl_error.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/opencl_interop.hpp"

namespace morphcl {

namespace {

// Fewer than these are done by the host in about the time that a launch takes.
constexpr std::size_t fewest_on_device = 8192;
constexpr std::uintptr_t cache_line_bytes = 64;
// A batch is split at multiples of this, so that every part starts a cache line if the first does.
constexpr std::size_t vertices_per_step = 4096;

// The caller's arrays as buffers: one for each distinct array, as two buffers over one memory are not coherent.
class HostBuffers {
 public:
  explicit HostBuffers(const Session& session) : context_(context_of(session)), queue_(queue_of(session)) {}
  ~HostBuffers() {
    // Where a later step failed, commands that are under way must not outlive the caller's arrays.
    try {
      queue_.finish();
    } catch (const cl::Error&) {
    }
  }
  HostBuffers(const HostBuffers&) = delete;
  HostBuffers& operator=(const HostBuffers&) = delete;

  template <class Element>
  const cl::Buffer& operator()(std::span<Element> values) {
    cl::Buffer& buffer = buffers_[values.data()];
    // The kernels write to no others than the caller's writable spans.
    if (!buffer())
      buffer = cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, values.size_bytes(),
                          const_cast<std::remove_const_t<Element>*>(values.data()));
    return buffer;
  }

  template <class Real>
  VertexBuffers operator()(const Vertices<Real>& vertices) {
    VertexBuffers buffers{vertices.layout(), {}};
    const auto arrays = vertices.arrays();
    for (std::size_t i = 0; i < arrays.size(); ++i) buffers.arrays[i] = (*this)(arrays[i]);
    return buffers;
  }

  template <class Real>
  ChoiceBuffers operator()(const MatrixChoice<Real>& choice) {
    if (const auto* index = std::get_if<MatrixIndices>(&choice)) return IndexBuffer{(*this)(*index)};
    if (const auto* blend = std::get_if<MatrixBlend<Real>>(&choice))
      return BlendBuffers{(*this)(blend->matrices), (*this)(blend->weights)};
    return {};
  }

  // Mapping is what brings results into the caller's memory. Runs when the queue gets there.
  template <class Element>
  void enqueue_bring_back(std::span<Element> values) {
    const cl::Buffer& buffer = (*this)(values);
    void* mapped = queue_.enqueueMapBuffer(buffer, CL_FALSE, CL_MAP_READ, 0, values.size_bytes());
    queue_.enqueueUnmapMemObject(buffer, mapped);
  }

 private:
  cl::Context context_;
  cl::CommandQueue queue_;
  std::map<const void*, cl::Buffer> buffers_;
};

// How many vertices to leave out in front so that every array of the rest starts a cache line; 0 where no number does.
template <class Real>
std::size_t vertices_before_cache_line(const Vertices<Real>& out) {
  const std::size_t bytes = out.stride() * sizeof(Real);
  for (std::size_t first = 0; first < cache_line_bytes; ++first) {
    const auto starts_line = [&](std::span<Real> array) {
      return (reinterpret_cast<std::uintptr_t>(array.data()) + first * bytes) % cache_line_bytes == 0;
    };
    const auto arrays = out.arrays();
    if (std::all_of(arrays.begin(), arrays.end(), starts_line)) return first;
  }
  return 0;
}

// The largest part of a batch of which every array is one allocation.
template <class Real>
std::size_t max_vertices_at_once(const DeviceInfo& device, const Vertices<Real>& out) {
  const std::size_t bytes = std::max(out.stride(), std::size_t{4}) * sizeof(Real);  // a quadruple of weights
  return std::max(device.max_allocation / bytes / vertices_per_step, std::size_t{1}) * vertices_per_step;
}

// False if a vertex asked for a matrix that is not there.
template <class Real>
bool transform_part(Session& session, const Transform<Real>& transform, const Vertices<const Real>& in,
                    const Vertices<Real>& out, const MatrixChoice<Real>& choice) {
  cl_uint bad_index = 0;
  const std::span<cl_uint> bad(&bad_index, 1);
  const bool chosen = !std::holds_alternative<std::monostate>(choice);
  checked("batch transform", [&] {
    HostBuffers buffers(session);
    enqueue_transform(session, transform, buffers(in), buffers(out), in.size(), buffers(choice),
                      chosen ? buffers(bad) : cl::Buffer());
    for (const std::span<Real> values : out.arrays()) buffers.enqueue_bring_back(values);
    if (chosen) buffers.enqueue_bring_back(bad);
    queue_of(session).finish();
  });
  return bad_index == 0;
}

template <class Real>
void transform_all(Session& session, const Transform<Real>& transform, const Vertices<const Real>& in,
                   const Vertices<Real>& out, const MatrixChoice<Real>& choice) {
  check_precision<Real>(session.info());
  check_in_and_out(in, out);
  check_choice(transform, choice, in.size());
  const std::size_t count = in.size();
  const std::size_t on_host = count < fewest_on_device ? count : vertices_before_cache_line(out);
  const MatrixChoice<Real> host_choice = part(choice, 0, on_host);
  transform_reference(transform, in.part(0, on_host), out.part(0, on_host), host_choice);
  bool all_found = true;
  const std::size_t max_at_once = max_vertices_at_once(session.info(), out);
  for (std::size_t first = on_host; first < count; first += max_at_once) {
    const std::size_t size = std::min(max_at_once, count - first);
    all_found &=
        transform_part(session, transform, in.part(first, size), out.part(first, size), part(choice, first, size));
  }
  // The kernels tell whether a matrix was missing; which one takes another look at the indices.
  check_indices(transform, all_found ? host_choice : choice);
}

}  // namespace

template <>
void transform_vertices(Session& session, const Transform<float>& transform, const Vertices<const float>& in,
                        const Vertices<float>& out, const MatrixChoice<float>& choice) {
  transform_all(session, transform, in, out, choice);
}

template <>
void transform_vertices(Session& session, const Transform<double>& transform, const Vertices<const double>& in,
                        const Vertices<double>& out, const MatrixChoice<double>& choice) {
  transform_all(session, transform, in, out, choice);
}

}  // namespace morphcl
