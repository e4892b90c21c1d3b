// Points through one affine matrix: a rotation about a line through a pivot, which is where rounding hurts.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/device/cl_error.hpp"
#include "host/device/session_access.hpp"
#include "lab/accuracy/elementwise.hpp"
#include "lab/accuracy/operations/half.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "lab/accuracy/operations/point_matrices.hpp"
#include "lab/accuracy/planar_operation.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/opencl_interop.hpp"

namespace morphcl::accuracy {

namespace {

struct Point {
  float x, y, z;
};

// results[row][i] = apply(row, point i).
template <class Load, class Apply>
Variant<float>::Run rows_of_points(std::size_t count, Load load, Apply apply) {
  return [=](Planes<float>& results) {
    float *x = results.plane(0), *y = results.plane(1), *z = results.plane(2);
    for_each_element(count, [=](std::size_t i) {
      const Point p = load(i);
      x[i] = apply(0, p);
      y[i] = apply(1, p);
      z[i] = apply(2, p);
    });
  };
}

auto stored_points(const Batch& batch) {
  const float *x = batch.stored.plane(0), *y = batch.stored.plane(1), *z = batch.stored.plane(2);
  return [=](std::size_t i) { return Point{x[i], y[i], z[i]}; };
}

auto multiply_add(const Rows32& m) {
  return [m](int row, const Point& p) { return p.x * m[row][0] + p.y * m[row][1] + p.z * m[row][2] + m[row][3]; };
}

auto fused(const Rows32& m) {
  return [m](int row, const Point& p) {
    return std::fma(p.x, m[row][0], std::fma(p.y, m[row][1], std::fma(p.z, m[row][2], m[row][3])));
  };
}

auto pivot_relative(const Rows32& linear, const std::array<float, 3>& pivot) {
  return [=](int row, const Point& p) {
    const float x = p.x - pivot[0], y = p.y - pivot[1], z = p.z - pivot[2];
    return std::fma(x, linear[row][0], std::fma(y, linear[row][1], z * linear[row][2])) + pivot[row];
  };
}

// Matrix entries as unevaluated sums of two floats, products and sums with their rounding errors carried along
// (Dekker; Ogita, Rump and Oishi's compensated dot product).
auto two_float(const Rows32& high, const Rows32& low) {
  return [=](int row, const Point& p) {
    float sum = high[row][3], rest = low[row][3];
    const auto add = [&](float value, float entry, float entry_rest) {
      const float product = value * entry;
      rest += std::fma(value, entry, -product) + value * entry_rest;
      const float next = sum + product, part = next - sum;
      rest += (sum - (next - part)) + (product - part);
      sum = next;
    };
    add(p.z, high[row][2], low[row][2]);
    add(p.y, high[row][1], low[row][1]);
    add(p.x, high[row][0], low[row][0]);
    return sum + rest;
  };
}

auto points_in_fp64(const Rows64& m) {
  return [m](int row, const Point& p) {
    const double x = p.x, y = p.y, z = p.z;
    return static_cast<float>(x * m[row][0] + y * m[row][1] + z * m[row][2] + m[row][3]);
  };
}

// Positions in `levels` equal steps over the box of the batch, or as halves.
struct Quantised {
  std::array<std::vector<std::uint16_t>, 3> codes;
  std::array<float, 3> bias{}, step{};
};

Quantised quantised(const Batch& batch, int levels) {
  Quantised q;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* values = batch.truth.plane(axis);
    const auto [low, high] = std::minmax_element(values, values + batch.size());
    q.bias[axis] = static_cast<float>(*low);
    q.step[axis] = static_cast<float>((*high - *low) / (levels - 1));
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const double code = q.step[axis] > 0 ? std::nearbyint((values[i] - q.bias[axis]) / q.step[axis]) : 0;
      q.codes[axis].push_back(static_cast<std::uint16_t>(std::clamp(code, 0.0, levels - 1.0)));
    }
  }
  return q;
}

Quantised as_halves(const Batch& batch) {
  Quantised q;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < batch.size(); ++i) q.codes[axis].push_back(to_half(batch.truth.plane(axis)[i]));
  return q;
}

float decoded(const Quantised& q, std::size_t axis, std::size_t i) {
  return std::fma(static_cast<float>(q.codes[axis][i]), q.step[axis], q.bias[axis]);
}

template <class Decode>
Planes<double> decoded_planes(const Quantised& q, std::size_t count, Decode decode) {
  Planes<double> planes(3, count);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < count; ++i) planes.plane(axis)[i] = decode(q, axis, i);
  return planes;
}

float half_at(const Quantised& q, std::size_t axis, std::size_t i) { return from_half(q.codes[axis][i]); }

Variant<float> quantised_variant(const std::string& name, int levels) {
  return {.name = name,
          .prepare = [levels](const Batch& batch) -> Variant<float>::Run {
            const auto q = std::make_shared<Quantised>(quantised(batch, levels));
            const auto load = [q = q.get()](std::size_t i) {
              return Point{decoded(*q, 0, i), decoded(*q, 1, i), decoded(*q, 2, i)};
            };
            return [q, run = rows_of_points(batch.size(), load, fused(rounded(composed_in_fp64(batch))))](
                       Planes<float>& results) { run(results); };
          },
          .stored =
              [levels](const Batch& batch) { return decoded_planes(quantised(batch, levels), batch.size(), decoded); }};
}

Variant<float> half_variant() {
  return {.name = "half storage",
          .prepare = [](const Batch& batch) -> Variant<float>::Run {
            const auto q = std::make_shared<Quantised>(as_halves(batch));
            const auto load = [q = q.get()](std::size_t i) {
              return Point{half_at(*q, 0, i), half_at(*q, 1, i), half_at(*q, 2, i)};
            };
            return [q, run = rows_of_points(batch.size(), load, fused(rounded(composed_in_fp64(batch))))](
                       Planes<float>& results) { run(results); };
          },
          .stored = [](const Batch& batch) { return decoded_planes(as_halves(batch), batch.size(), half_at); }};
}

// The product's own batch transform on the host and on the device.
Transform<float> shipped_transform(const Batch& batch) {
  const Rows32 m = rounded(composed_in_fp64(batch));
  return Transform<float>::points(AffineRows<float>{m[0], m[1], m[2]});
}

Variant<float>::Run shipped_on_host(const Batch& batch) {
  // The arrays are only read.
  auto plane = [&batch](std::size_t p) { return std::span<const float>(batch.stored.plane(p), batch.size()); };
  const auto in = Vertices<const float>::separate(plane(0), plane(1), plane(2));
  return [transform = shipped_transform(batch), in](Planes<float>& results) {
    const auto out = [&results](std::size_t p) { return std::span<float>(results.plane(p), results.size()); };
    transform_reference(transform, in, Vertices<float>::separate(out(0), out(1), out(2)));
  };
}

DeviceRun shipped_on_device(Session& session, const Batch& batch, Planes<float>& results) {
  const std::size_t bytes = batch.size() * sizeof(float);
  VertexBuffers in{VertexLayout::separate, {}}, out{VertexLayout::separate, {}};
  for (std::size_t axis = 0; axis < 3; ++axis)
    checked("buffers of vertices", [&] {
      in.arrays[axis] = cl::Buffer(context_of(session), CL_MEM_READ_WRITE, bytes);
      out.arrays[axis] = cl::Buffer(context_of(session), CL_MEM_READ_WRITE, bytes);
    });
  const cl::CommandQueue queue = queue_of(session);
  DeviceRun run;
  run.upload = [=, &batch] {
    for (std::size_t axis = 0; axis < 3; ++axis)
      checked("writing vertices",
              [&] { queue.enqueueWriteBuffer(in.arrays[axis], CL_TRUE, 0, bytes, batch.stored.plane(axis)); });
  };
  run.compute = [=, &session, transform = shipped_transform(batch), count = batch.size()](int times) {
    for (int i = 0; i < times; ++i) enqueue_transform(session, transform, in, out, count);
    checked("transforming vertices", [&] { queue.finish(); });
  };
  run.download = [=, &results] {
    for (std::size_t axis = 0; axis < 3; ++axis)
      checked("reading vertices",
              [&] { queue.enqueueReadBuffer(out.arrays[axis], CL_TRUE, 0, bytes, results.plane(axis)); });
  };
  return run;
}

std::vector<double> flat(const Rows64& rows) {
  std::vector<double> values;
  for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

std::vector<double> flat(const Rows32& rows) { return flat(widened(rows)); }

std::vector<double> pivot_constants(const Batch& batch) {
  std::vector<double> values = flat(rounded(composed_in_fp64(batch)));
  values.insert(values.end(), batch.constants.begin(), batch.constants.begin() + 3);
  return values;
}

std::vector<double> two_float_constants(const Batch& batch) {
  const Rows64 exact = composed_in_fp64(batch);
  std::vector<double> values = flat(rounded(exact)), low = flat(rounded(rest_of(exact)));
  values.insert(values.end(), low.begin(), low.end());
  return values;
}

std::vector<Variant<float>> point_variants() {
  const auto on_points = [](auto apply_for) {
    return [apply_for](const Batch& batch) -> Variant<float>::Run {
      return rows_of_points(batch.size(), stored_points(batch), apply_for(batch));
    };
  };
  const auto f32 = [](const char* kernel, auto constants) {
    return kernel_run("accuracy_points_f32", kernel, constants);
  };
  return {
      {.name = "fp32 naive",
       .prepare = on_points([](const Batch& b) { return multiply_add(composed_in_fp32(b)); }),
       .device = f32("multiply_add", [](const Batch& b) { return flat(composed_in_fp32(b)); }),
       .c_library = true},
      {.name = "composed in fp64",
       .prepare = on_points([](const Batch& b) { return multiply_add(rounded(composed_in_fp64(b))); }),
       .device = f32("multiply_add", [](const Batch& b) { return flat(rounded(composed_in_fp64(b))); })},
      {.name = "composed in fp64, fma", .prepare = shipped_on_host, .ships = true, .device = shipped_on_device},
      {.name = "pivot-relative",
       .prepare = on_points([](const Batch& b) { return pivot_relative(rounded(composed_in_fp64(b)), pivot32(b)); }),
       .device = f32("pivot_relative", pivot_constants)},
      {.name = "two-float",
       .prepare = on_points([](const Batch& b) {
         const Rows64 exact = composed_in_fp64(b);
         return two_float(rounded(exact), rounded(rest_of(exact)));
       }),
       .device = f32("two_float", two_float_constants)},
      {.name = "fp64",
       .prepare = on_points([](const Batch& b) { return points_in_fp64(composed_in_fp64(b)); }),
       .device =
           kernel_run("accuracy_points_f64", "in_fp64", [](const Batch& b) { return flat(composed_in_fp64(b)); })},
      half_variant(),
      quantised_variant("16-bit storage", 1 << 16),
      quantised_variant("10-bit storage", 1 << 10),
  };
}

// `coordinate` draws one about a pivot of the given coordinate.
InputFamily point_transform_family(const char* name, const char* text, std::array<double, 3> pivot, auto coordinate,
                                   double pixels) {
  return {name, text,
          [=](Random& random, std::size_t count) {
            return drawn(random, 3, count, {pivot[0], pivot[1], pivot[2]}, [=](Random& r, double* p) {
              for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = coordinate(r, pivot[axis]);
            });
          },
          pixels};
}

}  // namespace

Operation point_transform() {
  PlanarOperation<float> op;
  op.about = {.name = "point-transform",
              .title = "points turned by 30 degrees about a line through a pivot",
              .results = "model units",
              .format = binary32,
              .plotted = Measure::max_pixels,
              .target = 0.01,
              .reason = "a hundredth of a pixel"};
  op.results = 3;
  op.families = {
      point_transform_family(
          "benign", "points of the unit box, pivot (1/2, 1/2, 1/2); 1080 pixels a unit", {0.5, 0.5, 0.5},
          [](Random& r, double) { return r.uniform(0, 1); }, 1080),
      point_transform_family(
          "wide", "coordinates of either sign from 2^-20 to 2^20, pivot 1000; 1080 pixels for 2^21", {1000, 1000, 1000},
          [](Random& r, double) { return r.signed_binades(-20, 19); }, 1080 / 0x1p21),
      point_transform_family(
          "adversarial", "points within 1 of a pivot at (10000, 13000, -9000); 540 pixels a unit",
          {10000, 13000, -9000}, [](Random& r, double pivot) { return pivot + r.uniform(-1, 1); }, 540),
  };
  op.reference =
      Reference([](const Inputs& in, std::size_t i, auto* results) { exact_pivot_rotation(in, i, results); });
  op.variants = point_variants();
  op.streams = true;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
