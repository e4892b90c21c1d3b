// device_child: what a process of its own finds out about its device, as lines "name value".
//
//   device_child info [DEVICE [THREADS]]     threads, compute_units, name, verdict
//   device_child transform COUNT...          hash of all batch transforms of COUNT vertices each; fills the cache
//   device_child arrays COUNT...             the same of floats in separate arrays alone
//   device_child points COUNT...             the same of points in one layout alone
//   device_child split COUNT                 max_allocation of the device, and how many of COUNT vertices that
//                                            transform_vertices() transforms in place differ from the reference
//   device_child stray_write                 a kernel that writes outside its buffer, for checkers that should see it
// An Error is printed as "error MESSAGE" and its exit code is the process's.
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "host/device/launch.hpp"
#include "host/device/session_access.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/error.hpp"
#include "tests/batch/device_run.hpp"

namespace {

using namespace morphcl;

void print_info(const std::string& device, int threads) {
  fmt::print("threads {}\n", prepare_process(threads));
  SessionOptions options;
  options.device = device;
  const auto session = Session::open(options);
  fmt::print("compute_units {}\nname {}\nverdict {}\n", session->info().compute_units, session->info().name,
             session->verdict() == Verdict::identical ? "identical" : session->verdict_detail());
}

template <class Real>
class TransformHash {
 public:
  explicit TransformHash(Session& session) : session_(session) {}

  // One kind of transform with every choice of matrices that it allows.
  void add(const Transform<Real>& single, const Transform<Real>& palette, std::span<const VertexLayout> layouts,
           std::size_t count) {
    const auto indices = testing::make_indices(count, palette.matrix_count());
    for (const VertexLayout layout : layouts) {
      const auto in = testing::make_batch<Real>(layout, count, testing::Family::benign, count);
      add(testing::run_on_device(session_, single, in));
      add(testing::run_on_device(session_, palette, in, indices));
      if (palette.kind() == TransformKind::normals) continue;
      add(testing::run_on_device(session_, palette, in, testing::make_blend<Real>(count, palette.matrix_count())));
    }
  }

  void add_all_kinds(std::span<const VertexLayout> layouts, std::size_t count) {
    const auto matrix = testing::general_matrix<Real>();
    const auto matrices = testing::make_palette<Real>(5);
    const std::span<const AffineRows<Real>> palette(matrices);
    const auto projections = testing::make_projective_palette<Real>(5);
    add(Transform<Real>::points(matrix), Transform<Real>::points(palette), layouts, count);
    add(Transform<Real>::vectors(matrix), Transform<Real>::vectors(palette), layouts, count);
    add(Transform<Real>::normals(matrix), Transform<Real>::normals(palette), layouts, count);
    add(Transform<Real>::project(testing::perspective_matrix<Real>()),
        Transform<Real>::project(std::span<const ProjectiveRows<Real>>(projections)), layouts, count);
  }

  void add(const testing::Batch<Real>& results) {
    for (const auto& values : results.arrays)
      hash_ = XXH3_64bits_withSeed(values.data(), values.size() * sizeof(Real), hash_);
  }

  XXH64_hash_t value() const { return hash_; }

 private:
  Session& session_;
  XXH64_hash_t hash_ = 0;
};

enum class Extent { all, arrays, points };

void print_transform_hash(const std::vector<std::size_t>& counts, Extent extent) {
  const auto session = Session::open({});
  TransformHash<float> floats(*session);
  TransformHash<double> doubles(*session);
  const std::span<const VertexLayout> layouts(testing::all_layouts);
  for (const std::size_t count : counts) {
    if (extent == Extent::points) {
      const auto in = testing::make_batch<float>(VertexLayout::separate, count, testing::Family::benign, count);
      floats.add(testing::run_on_device(*session, Transform<float>::points(testing::general_matrix<float>()), in));
    } else {
      floats.add_all_kinds(extent == Extent::all ? layouts : layouts.first(1), count);
      if (extent == Extent::all) doubles.add_all_kinds(layouts, count);
    }
  }
  session->store_programs();
  fmt::print("hash {:016x}{:016x}\n", floats.value(), doubles.value());
}

// Vertices `first` to `first + count - 1` of an endless sequence.
std::vector<float> sequence(std::size_t first, std::size_t count) {
  std::vector<float> records(3 * count);
  for (std::size_t i = 0; i < records.size(); ++i) records[i] = static_cast<float>((3 * first + i) % 100003);
  return records;
}

void print_differences(std::size_t count) {
  const auto session = Session::open({});
  const auto transform = Transform<float>::points(testing::general_matrix<float>());
  std::vector<float> records = sequence(0, count);
  const auto vertices = Vertices<float>::xyz(records);
  transform_vertices(*session, transform, vertices, vertices);
  std::size_t different = 0;
  constexpr std::size_t step = std::size_t{1} << 16;
  for (std::size_t first = 0; first < count; first += step) {
    std::vector<float> expected = sequence(first, std::min(step, count - first));
    const auto some = Vertices<float>::xyz(expected);
    transform_reference(transform, some, some);
    for (std::size_t i = 0; i < expected.size(); ++i) different += expected[i] != records[3 * first + i];
  }
  fmt::print("largest_allocation {}\ndifferent {}\n", session->info().max_allocation, different);
}

using Values = Argument<cl_int, "values", "int">;

void write_outside() {
  const auto session = Session::open({});
  const KernelSource source{"stray",
                            "tests/device/device_child.cpp",
                            "kernel void stray(global int* values) { values[get_global_id(0) + 4] = 1; }",
                            {{"stray", {{"values", "int"}}}}};
  const BufferAs<Values> values(cl::Buffer(context_of(*session), CL_MEM_READ_WRITE, 4 * sizeof(cl_int)));
  launch(queue_of(*session), kernel_of(*session, source, "stray"), cl::NDRange(4), cl::NDRange(1), values);
  queue_of(*session).finish();
}

}  // namespace

int main(int count, char** values) {
  const std::vector<std::string> arguments(values + 1, values + count);
  try {
    if (arguments.empty()) return 2;
    if (arguments[0] == "info") {
      print_info(arguments.size() > 1 ? arguments[1] : "", arguments.size() > 2 ? std::stoi(arguments[2]) : 0);
    } else if (arguments[0] == "transform" || arguments[0] == "arrays" || arguments[0] == "points") {
      std::vector<std::size_t> counts;
      for (std::size_t i = 1; i < arguments.size(); ++i) counts.push_back(std::stoul(arguments[i]));
      print_transform_hash(counts, arguments[0] == "transform" ? Extent::all
                                   : arguments[0] == "arrays"  ? Extent::arrays
                                                               : Extent::points);
    } else if (arguments[0] == "split") {
      print_differences(std::stoul(arguments.at(1)));
    } else if (arguments[0] == "stray_write") {
      write_outside();
    } else {
      return 2;
    }
  } catch (const Error& error) {
    fmt::print("error {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
