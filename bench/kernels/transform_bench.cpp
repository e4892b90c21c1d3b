// Batch transforms beside other ways of doing the same, and beside copying as many bytes.
//
//   morphcl_bench_transform [--threads=N] [--benchmark_...]     N: of everything that is timed; 1 unless given
//
// Names: PRECISION/LAYOUT/WHAT/WHO/VERTICES. Bytes are those of the vertices, read once and written once, and of the
// choice of matrices.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/kernels/transform_copy.hpp"
#include "bench/kernels/transform_peers.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/error.hpp"
#include "morphcl/opencl_interop.hpp"

namespace {

using namespace morphcl;

constexpr std::size_t large = std::size_t{1} << 23;
constexpr std::size_t palette_size = 64;

int threads = 1;

Session& session() {
  static const std::shared_ptr<Session> opened = Session::open({});
  return *opened;
}

// Memory that all benchmarks share: input, output and the choice of matrices, at most five doubles a vertex each; on
// huge pages where there are any.
std::byte* memory(std::size_t which) {
  struct Free {
    void operator()(std::byte* bytes) const { std::free(bytes); }
  };
  constexpr std::size_t bytes = large * 5 * sizeof(double), huge_page = std::size_t{2} << 20;
  static std::unique_ptr<std::byte, Free> parts[3];
  if (!parts[which]) {
    parts[which].reset(static_cast<std::byte*>(std::aligned_alloc(huge_page, bytes)));
    if (!parts[which]) throw std::bad_alloc();
    madvise(parts[which].get(), bytes, MADV_HUGEPAGE);
  }
  return parts[which].get();
}

template <class Real>
Real* reals(std::size_t which) {
  return reinterpret_cast<Real*>(memory(which));
}

template <class Real>
constexpr const char* precision_name = sizeof(Real) == 4 ? "f32" : "f64";

constexpr std::size_t reals_of(VertexLayout layout) { return array_count(layout) * reals_per_vertex(layout); }

template <class Real>
Vertices<Real> vertices(std::size_t which, VertexLayout layout, std::size_t count) {
  const std::span<Real> all(reals<Real>(which), count * reals_of(layout));
  if (layout == VertexLayout::separate)
    return Vertices<Real>::separate(all.first(count), all.subspan(count, count), all.last(count));
  return layout == VertexLayout::xyz ? Vertices<Real>::xyz(all) : Vertices<Real>::xyzw(all);
}

// Numbers of ordinary size: infinities and denormals would time something else.
template <class Real>
void fill(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) reals<Real>(0)[i] = Real(1) + static_cast<Real>(i % 1000) / 1000;
}

template <class Real>
AffineRows<Real> matrix() {
  return {{Real(0.5), Real(0.25), 1, 3}, {Real(0.125), -2, 1, -7}, {Real(0.75), 1, Real(0.25), 100}};
}

template <class Real>
struct What {
  const char* name;
  Transform<Real> transform;
  MatrixChoice<Real> choice;
  std::size_t choice_bytes;  // a vertex
};

template <class Real>
std::vector<What<Real>> all_kinds(std::size_t count) {
  const auto rows = matrix<Real>();
  const std::vector<AffineRows<Real>> affine(palette_size, rows);
  const auto palette = Transform<Real>::points(std::span<const AffineRows<Real>>(affine));
  auto* indices = reinterpret_cast<std::uint32_t*>(memory(2));
  auto* influences = reinterpret_cast<std::array<std::uint16_t, 4>*>(memory(2));
  auto* weights = reinterpret_cast<std::array<Real, 4>*>(influences + large);
  return {{"points", Transform<Real>::points(rows), {}, 0},
          {"project", Transform<Real>::project({rows.x, rows.y, rows.z, {0, 0, 1, 1}}), {}, 0},
          {"normals", Transform<Real>::normals(rows), {}, 0},
          {"points_by_index", palette, MatrixIndices(indices, count), sizeof *indices},
          {"points_blended", palette, MatrixBlend<Real>{{influences, count}, {weights, count}},
           sizeof *influences + sizeof *weights}};
}

void fill_choice(const std::string& what, std::size_t count, std::size_t weight_bytes) {
  if (what == "points_by_index")
    for (std::size_t i = 0; i < count; ++i)
      reinterpret_cast<std::uint32_t*>(memory(2))[i] = static_cast<std::uint32_t>(i * 7 % palette_size);
  if (what != "points_blended") return;
  for (std::size_t i = 0; i < 4 * count; ++i)
    reinterpret_cast<std::uint16_t*>(memory(2))[i] = static_cast<std::uint16_t>(i * 7 % palette_size);
  std::memset(memory(2) + large * 4 * sizeof(std::uint16_t), 0, 4 * count * weight_bytes);
}

void add(const std::string& name, std::size_t count, std::size_t bytes, const std::function<void()>& prepare,
         const std::function<void()>& work) {
  benchmark::RegisterBenchmark(fmt::format("{}/{}", name, count).c_str(), [=](benchmark::State& state) {
    prepare();
    work();
    for (auto _ : state) work();
    const auto done = static_cast<double>(state.iterations());
    state.SetBytesProcessed(static_cast<std::int64_t>(done * static_cast<double>(bytes)));
    state.SetItemsProcessed(static_cast<std::int64_t>(done * static_cast<double>(count)));
  })->UseRealTime();
}

template <class Real>
void add_copies(VertexLayout layout) {
  const std::size_t bytes = large * reals_of(layout) * sizeof(Real);
  const std::string name = fmt::format("{}/{}/copy", precision_name<Real>, name_of(layout));
  const auto prepare = [=] { fill<Real>(large * reals_of(layout)); };
  add(name + "/memcpy", large, 2 * bytes, prepare, [=] { bench::copy(memory(0), memory(1), bytes, threads); });
  add(name + "/past_cache", large, 2 * bytes, prepare,
      [=] { bench::copy_past_cache(memory(0), memory(1), bytes, threads); });
}

template <class Real>
void add_peers(VertexLayout layout) {
  const std::size_t bytes = 2 * large * reals_of(layout) * sizeof(Real);
  const auto rows = matrix<Real>();
  const bench::Rows<Real> plain = {rows.x, rows.y, rows.z};
  const std::string name = fmt::format("{}/{}/points", precision_name<Real>, name_of(layout));
  const auto prepare = [=] { fill<Real>(large * reals_of(layout)); };
  if (layout == VertexLayout::separate) {
    const auto arrays = [](std::size_t which) {
      Real* first = reals<Real>(which);
      return bench::Arrays<Real>{first, first + large, first + 2 * large};
    };
    add(name + "/loop", large, bytes, prepare,
        [=] { bench::transform_with_loop(plain, arrays(0), arrays(1), large, threads); });
    return;
  }
  add(name + "/glm", large, bytes, prepare,
      [=] { bench::transform_with_glm(plain, reals<Real>(0), reals<Real>(1), reals_of(layout), large, threads); });
#ifdef MORPHCL_BENCH_EIGEN
  if (layout == VertexLayout::xyzw)
    add(name + "/eigen", large, bytes, prepare,
        [=] { bench::transform_with_eigen(plain, reals<Real>(0), reals<Real>(1), large, threads); });
#endif
}

template <class Real>
void add_morphcl(VertexLayout layout, std::size_t count) {
  for (const What<Real>& what : all_kinds<Real>(count)) {
    const std::size_t bytes = count * (2 * reals_of(layout) * sizeof(Real) + what.choice_bytes);
    const std::string name = fmt::format("{}/{}/{}/", precision_name<Real>, name_of(layout), what.name);
    const auto prepare = [=] {
      fill<Real>(count * reals_of(layout));
      fill_choice(what.name, count, sizeof(Real));
    };
    add(name + "morphcl", count, bytes, prepare, [=] {
      transform_vertices(session(), what.transform, vertices<const Real>(0, layout, count),
                         vertices<Real>(1, layout, count), what.choice);
    });
  }
}

// Small batches, beside the same on the device alone and in plain loops: where the one overtakes the other.
void add_small(std::size_t count) {
  const auto layout = VertexLayout::separate;
  const auto transform = Transform<float>::points(matrix<float>());
  const std::size_t bytes = count * 6 * sizeof(float);
  const auto prepare = [=] { fill<float>(3 * count); };
  const std::string name = "f32/separate/points/";
  add(name + "morphcl", count, bytes, prepare, [=] {
    transform_vertices(session(), transform, vertices<const float>(0, layout, count),
                       vertices<float>(1, layout, count));
  });
  add(name + "device", count, bytes, prepare, [=] {
    static const cl::Buffer in(context_of(session()), CL_MEM_READ_WRITE, large / 8 * sizeof(float));
    const VertexBuffers buffers{layout, {in, in, in}};
    enqueue_transform(session(), transform, buffers, buffers, count);
    queue_of(session()).finish();
  });
  add(name + "host", count, bytes, prepare, [=] {
    transform_reference(transform, vertices<const float>(0, layout, count), vertices<float>(1, layout, count));
  });
}

template <class Real>
void add_all() {
  for (const VertexLayout layout : {VertexLayout::separate, VertexLayout::xyz, VertexLayout::xyzw}) {
    add_copies<Real>(layout);
    add_peers<Real>(layout);
    add_morphcl<Real>(layout, large);
  }
}

// Takes --threads=N out of the arguments.
void read_threads(std::vector<char*>& arguments) {
  const std::string option = "--threads=";
  const auto found = std::find_if(arguments.begin(), arguments.end(),
                                  [&](const char* argument) { return std::string(argument).starts_with(option); });
  if (found == arguments.end()) return;
  threads = std::max(1, std::atoi(*found + option.size()));
  arguments.erase(found);
}

}  // namespace

int main(int count, char** values) try {
  std::vector<char*> arguments(values, values + count);
  read_threads(arguments);
  prepare_process(threads);
  add_all<float>();
  add_all<double>();
  for (const std::size_t size : {1, 64, 1024, 8191, 8192, 16384, 65536, 1 << 20}) add_small(size);
  auto left = static_cast<int>(arguments.size());
  benchmark::Initialize(&left, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(left, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "{}\n", error.what());
  return error.exit_code();
}
