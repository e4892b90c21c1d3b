#include "host/device/transform_points.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "host/device/launch.hpp"
#include "host/device/normal_rows.hpp"

namespace morphcl {

namespace {

constexpr std::size_t lanes = 16;
// A CPU walks long runs; elsewhere neighbours share a group. Multiples of `lanes`, as the kernels demand.
constexpr std::size_t points_per_cpu_item = 4096;
constexpr std::size_t group_size_elsewhere = 64;
// Below any device's largest allocation, and a multiple of a cache line.
constexpr std::size_t most_points_at_once = std::size_t{1} << 24;
// From here on results leave the cache before they are read again.
constexpr std::size_t past_cache_bytes = std::size_t{8} << 20;
constexpr std::uintptr_t vector_bytes = lanes * sizeof(float);

cl_float4 device_row(const MatrixRow& row) { return {{row[0], row[1], row[2], row[3]}}; }

bool is_aligned(std::span<float> values) { return reinterpret_cast<std::uintptr_t>(values.data()) % vector_bytes == 0; }

// The user's arrays as buffers: one for each distinct array, as two buffers over one memory are not coherent.
class HostBuffers {
 public:
  explicit HostBuffers(const Session& session) : context_(session.context()), queue_(session.queue()) {}
  ~HostBuffers() {
    // Where a later step failed, commands that are under way must not outlive the caller's arrays.
    try {
      queue_.finish();
    } catch (const cl::Error&) {
    }
  }
  HostBuffers(const HostBuffers&) = delete;
  HostBuffers& operator=(const HostBuffers&) = delete;

  const cl::Buffer& operator()(std::span<const float> values) {
    cl::Buffer& buffer = buffers_[values.data()];
    // The outputs are the caller's writable spans; the kernels write to no others.
    if (!buffer())
      buffer = cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, values.size_bytes(),
                          const_cast<float*>(values.data()));
    return buffer;
  }

 private:
  cl::Context context_;
  cl::CommandQueue queue_;
  std::map<const float*, cl::Buffer> buffers_;
};

void transform_some(Session& session, const char* kernel_name, std::span<const MatrixRow> rows,
                    const ConstPointArrays& in, const PointArrays& out, bool past_cache) {
  const std::size_t count = in.x.size();
  const bool cpu = session.info().is_cpu;
  const std::size_t points_per_item = cpu ? points_per_cpu_item : lanes;
  const std::size_t group = cpu ? 1 : group_size_elsewhere;
  const std::size_t items = (count + points_per_item - 1) / points_per_item;
  const cl::NDRange global((items + group - 1) / group * group), local(group);

  HostBuffers buffer(session);
  cl::Kernel kernel = session.kernel("transform_points", kernel_name);
  const auto start = [&](const auto&... row) {
    launch(session.queue(), kernel, global, local, row..., buffer(in.x), buffer(in.y), buffer(in.z), buffer(out.x),
           buffer(out.y), buffer(out.z), cl_ulong{count}, cl_ulong{points_per_item}, cl_uint{past_cache});
  };
  checked("batch transform", [&] {
    if (rows.size() == 4)
      start(device_row(rows[0]), device_row(rows[1]), device_row(rows[2]), device_row(rows[3]));
    else
      start(device_row(rows[0]), device_row(rows[1]), device_row(rows[2]));
    // Mapping is what brings the results into the caller's memory; one wait for all three.
    for (const std::span<float> values : {out.x, out.y, out.z}) {
      void* mapped = session.queue().enqueueMapBuffer(buffer(values), CL_FALSE, CL_MAP_READ, 0, values.size_bytes());
      session.queue().enqueueUnmapMemObject(buffer(values), mapped);
    }
    session.queue().finish();
  });
}

void transform(Session& session, const char* kernel_name, std::span<const MatrixRow> rows, const ConstPointArrays& in,
               const PointArrays& out) {
  const std::size_t count = checked_size(in, out);
  const bool past_cache =
      count * 6 * sizeof(float) >= past_cache_bytes && is_aligned(out.x) && is_aligned(out.y) && is_aligned(out.z);
  for (std::size_t first = 0; first < count; first += most_points_at_once) {
    const std::size_t size = std::min(most_points_at_once, count - first);
    transform_some(session, kernel_name, rows,
                   {in.x.subspan(first, size), in.y.subspan(first, size), in.z.subspan(first, size)},
                   {out.x.subspan(first, size), out.y.subspan(first, size), out.z.subspan(first, size)}, past_cache);
  }
}

}  // namespace

void transform_points(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  transform(session, "transform_points", std::array{rows.x, rows.y, rows.z}, in, out);
}

void project_points(Session& session, const ProjectiveRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  transform(session, "project_points", std::array{rows.x, rows.y, rows.z, rows.w}, in, out);
}

void transform_vectors(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  transform(session, "transform_vectors", std::array{rows.x, rows.y, rows.z}, in, out);
}

void transform_normals(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out) {
  const AffineRows normals = normal_rows(rows);
  transform(session, "transform_normals", std::array{normals.x, normals.y, normals.z}, in, out);
}

}  // namespace morphcl
