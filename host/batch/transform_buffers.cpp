#include <fmt/format.h>

#include <string>
#include <string_view>

#include "host/batch/transform.hpp"
#include "host/device/launch.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/opencl_interop.hpp"

namespace morphcl {

namespace {

namespace layout {
using uint = cl_uint;
using ulong = cl_ulong;
#include "kernels/transform_constants.h"
static_assert(sizeof(TransformConstants) == 32);
}  // namespace layout

// What the kernels take.
template <class Real>
constexpr bool is_single = std::is_same_v<Real, float>;

template <class Real, Text name>
using Reals = std::conditional_t<is_single<Real>, Argument<Real, name, "float">, Argument<Real, name, "double">>;
template <class Real>
using X = Reals<Real, "x">;
template <class Real>
using Y = Reals<Real, "y">;
template <class Real>
using Z = Reals<Real, "z">;
template <class Real>
using OutX = Reals<Real, "out_x">;
template <class Real>
using OutY = Reals<Real, "out_y">;
template <class Real>
using OutZ = Reals<Real, "out_z">;
template <class Real>
using In = Reals<Real, "records">;
template <class Real>
using Out = Reals<Real, "out">;
template <class Real>
using Weight = Reals<Real, "weight">;
template <class Real>
using Rows = std::conditional_t<is_single<Real>, Argument<MatrixRow<Real>, "rows", "float4">,
                                Argument<MatrixRow<Real>, "rows", "double4">>;
using Index = Argument<cl_uint, "index", "uint">;
using Influence = Argument<cl_ulong, "influence", "ulong">;  // four ushorts
using BadIndex = Argument<cl_uint, "bad_index", "uint">;

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
constexpr std::size_t min_streamed_bytes = std::size_t{8} << 20;

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

template <class Real>
constexpr const char* stage = is_single<Real> ? "transform_f32" : "transform_f64";

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

    // Copied: the caller's transform may be gone when the kernel runs.
    const auto matrix_rows = transform.rows();
    const BufferAs<Rows<Real>> rows(cl::Buffer(context_of(session), CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                               matrix_rows.size_bytes(),
                                               const_cast<MatrixRow<Real>*>(matrix_rows.data())));
    layout::TransformConstants constants{};
    constants.count = count;
    constants.run_length = share.run_length;
    constants.runs = static_cast<cl_uint>(share.runs);
    constants.kind = static_cast<cl_uint>(transform.kind());
    constants.matrix_count = static_cast<cl_uint>(transform.matrix_count());
    constants.stream_stores = reals * sizeof(Real) >= min_streamed_bytes;
    const Kernel kernel = kernel_of(session, kernel_source(stage<Real>), kernel_name(in.layout, choice));
    const auto start = [&](const auto&... choosing) {
      const auto with = [&](const auto&... vertices) {
        launch(queue_of(session), kernel, global, local, Named{"constants", constants, "TransformConstants"}, rows,
               choosing..., vertices...);
      };
      if (in.layout == VertexLayout::separate)
        with(BufferAs<X<Real>>(in.arrays[0]), BufferAs<Y<Real>>(in.arrays[1]), BufferAs<Z<Real>>(in.arrays[2]),
             BufferAs<OutX<Real>>(out.arrays[0]), BufferAs<OutY<Real>>(out.arrays[1]),
             BufferAs<OutZ<Real>>(out.arrays[2]));
      else
        with(BufferAs<In<Real>>(in.arrays[0]), BufferAs<Out<Real>>(out.arrays[0]));
    };
    if (chosen && !bad_index()) bad_index = cl::Buffer(context_of(session), CL_MEM_WRITE_ONLY, sizeof(cl_uint));
    const BufferAs<BadIndex> bad(bad_index);
    if (const auto* by_index = std::get_if<IndexBuffer>(&choice)) {
      check_size(by_index->index, count * sizeof(cl_uint), "the matrix indices");
      start(bad, BufferAs<Index>(by_index->index));
    } else if (const auto* blend = std::get_if<BlendBuffers>(&choice)) {
      check_size(blend->matrices, count * 4 * sizeof(cl_ushort), "the matrices to blend");
      check_size(blend->weights, count * 4 * sizeof(Real), "the weights");
      start(bad, BufferAs<Influence>(blend->matrices), BufferAs<Weight<Real>>(blend->weights));
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
