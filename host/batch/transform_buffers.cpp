#include "host/batch/transform_buffers.hpp"

#include <fmt/format.h>

#include <string>
#include <tuple>

#include "host/device/launch.hpp"

namespace morphcl {

namespace {

// How the vertices are shared out: `runs` runs of `run_length` for each work-item. A multiple of 16, as the kernels
// demand. A CPU walks long runs, of records four at a time, as its prefetcher brings in more from several streams than
// from one, and separate arrays are several already; elsewhere neighbours share a group.
struct Share {
  std::size_t run_length, runs, group;
};

Share share_of_item(const DeviceInfo& device, VertexLayout layout) {
  if (!device.is_cpu) return {16, 1, 64};
  return layout == VertexLayout::separate ? Share{4096, 1, 1} : Share{1024, 4, 1};
}

// From here on results leave the cache before they are read again.
constexpr std::size_t past_cache_bytes = std::size_t{8} << 20;

void check_size(const cl::Buffer& buffer, std::size_t bytes, const char* what) {
  const std::size_t held = buffer() ? buffer.getInfo<CL_MEM_SIZE>() : 0;
  if (held < bytes)
    throw Error(ErrorKind::usage, "",
                fmt::format("a buffer of {} bytes for {}; at least {} are needed", held, what, bytes));
}

void check_vertices(const VertexBuffers& vertices, std::size_t count, std::size_t real_bytes, const char* what) {
  for (std::size_t array = 0; array < array_count(vertices.layout); ++array)
    check_size(vertices.arrays[array], count * reals_per_vertex(vertices.layout) * real_bytes, what);
}

// As the kernels take them.
auto arguments(const VertexBuffers& in, const VertexBuffers& out, auto&& use) {
  if (in.layout == VertexLayout::separate)
    return use(std::tie(in.arrays[0], in.arrays[1], in.arrays[2], out.arrays[0], out.arrays[1], out.arrays[2]));
  return use(std::tie(in.arrays[0], out.arrays[0]));
}

template <class Real>
constexpr const char* stage = std::is_same_v<Real, float> ? "transform_f32" : "transform_f64";

std::string kernel_name(VertexLayout layout, const ChoiceBuffers& choice) {
  constexpr const char* suffixes[] = {"", "_by_index", "_blended"};
  return fmt::format("transform_{}{}", name_of(layout), suffixes[choice.index()]);
}

}  // namespace

template <class Real>
void check_precision(const DeviceInfo& device) {
  if (std::is_same_v<Real, double> && !device.fp64)
    throw Error(ErrorKind::no_device, "",
                fmt::format("device \"{}\" does not compute in double precision (cl_khr_fp64); transform floats, or "
                            "use another device",
                            device.name));
}

template <class Real>
void enqueue_transform(Session& session, const Transform<Real>& transform, const VertexBuffers& in,
                       const VertexBuffers& out, std::size_t count, const ChoiceBuffers& choice, cl::Buffer bad_index) {
  check_precision<Real>(session.info());
  if (in.layout != out.layout)
    throw Error(ErrorKind::usage, "",
                fmt::format("the input is {} and the output {}; both must have one layout", name_of(in.layout),
                            name_of(out.layout)));
  const bool chosen = !std::holds_alternative<std::monostate>(choice);
  check_choice_kind(transform, chosen, std::holds_alternative<BlendBuffers>(choice));
  checked("batch transform", [&] {
    check_vertices(in, count, sizeof(Real), "the vertices");
    check_vertices(out, count, sizeof(Real), "the results");
    const Share share = share_of_item(session.info(), in.layout);
    const std::size_t per_item = share.run_length * share.runs, items = (count + per_item - 1) / per_item;
    const cl::NDRange global((items + share.group - 1) / share.group * share.group), local(share.group);
    const std::size_t reals = 2 * array_count(out.layout) * reals_per_vertex(out.layout) * count;
    const cl_uint past_cache = reals * sizeof(Real) >= past_cache_bytes;

    // Copied: the caller's transform may be gone when the kernel runs.
    const auto rows = transform.rows();
    const cl::Buffer row_buffer(session.context(), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, rows.size_bytes(),
                                const_cast<MatrixRow<Real>*>(rows.data()));
    const auto kind = static_cast<cl_uint>(transform.kind());
    const auto matrix_count = static_cast<cl_uint>(transform.matrix_count());
    cl::Kernel kernel = session.kernel(stage<Real>, kernel_name(in.layout, choice));
    const auto start = [&](const auto&... choosing) {
      arguments(in, out, [&](const auto& vertices) {
        std::apply(
            [&](const auto&... buffers) {
              launch(session.queue(), kernel, global, local, row_buffer, kind, choosing..., buffers..., cl_ulong{count},
                     cl_ulong{share.run_length}, static_cast<cl_uint>(share.runs), past_cache);
            },
            vertices);
      });
    };
    if (chosen && !bad_index()) bad_index = cl::Buffer(session.context(), CL_MEM_WRITE_ONLY, sizeof(cl_uint));
    if (const auto* by_index = std::get_if<IndexBuffer>(&choice)) {
      check_size(by_index->index, count * sizeof(cl_uint), "the matrix indices");
      start(matrix_count, bad_index, by_index->index);
    } else if (const auto* blend = std::get_if<BlendBuffers>(&choice)) {
      check_size(blend->matrices, count * 4 * sizeof(cl_ushort), "the matrices to blend");
      check_size(blend->weights, count * 4 * sizeof(Real), "the weights");
      start(matrix_count, bad_index, blend->matrices, blend->weights);
    } else {
      start();
    }
  });
}

template void check_precision<float>(const DeviceInfo&);
template void check_precision<double>(const DeviceInfo&);
template void enqueue_transform(Session&, const Transform<float>&, const VertexBuffers&, const VertexBuffers&,
                                std::size_t, const ChoiceBuffers&, cl::Buffer);
template void enqueue_transform(Session&, const Transform<double>&, const VertexBuffers&, const VertexBuffers&,
                                std::size_t, const ChoiceBuffers&, cl::Buffer);

}  // namespace morphcl
