// The matrix of a camera: eye, target and up to world -> eye.
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/matrix_entries.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

template <class Real>
Entries3x3 naive_look_at(double ex, double ey, double ez, double tx, double ty, double tz, double ux, double uy,
                         double uz) {
  using Vector = glm::vec<3, Real>;
  return entries_3x3(glm::lookAt(Vector(ex, ey, ez), Vector(tx, ty, tz), Vector(ux, uy, uz)));
}

Entries3x3 shipped_look_at_in_fp64(double ex, double ey, double ez, double tx, double ty, double tz, double ux,
                                   double uy, double uz) {
  return entries_3x3(look_at({ex, ey, ez}, {tx, ty, tz}, {ux, uy, uz}).world_to_eye);
}

Entries3x3 shipped_look_at_rounded(double ex, double ey, double ez, double tx, double ty, double tz, double ux,
                                   double uy, double uz) {
  return entries_3x3(to_fp32(look_at({ex, ey, ez}, {tx, ty, tz}, {ux, uy, uz}).world_to_eye));
}

// `angle` is about that of up and the view axis; inputs are binary32 numbers, so that all variants read the same.
InputFamily look_at_family(const char* name, const char* text, double distance, int low, int high, bool near_parallel) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 9, count, {}, [=](Random& r, double* in) {
              for (int axis = 0; axis < 3; ++axis) {
                in[axis + 3] = static_cast<float>(distance * r.uniform(-1, 1));
                in[axis] = static_cast<float>(in[axis + 3] + r.uniform(0.5, 1));
              }
              const double angle = r.binades(low, high);
              for (int axis = 0; axis < 3; ++axis) {
                const double view = in[axis] - in[axis + 3];
                in[axis + 6] = near_parallel ? view * (1 + angle * r.uniform(-1, 1)) : r.uniform(-1, 1);
              }
              for (int axis = 6; axis < 9; ++axis) in[axis] = static_cast<float>(in[axis]);
            });
          }};
}

template <class Number>
using ExactVector = std::array<Number, 3>;

template <class Number>
ExactVector<Number> unit(const ExactVector<Number>& v) {
  const Number length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

template <class Number>
ExactVector<Number> cross(const ExactVector<Number>& a, const ExactVector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Operation matrix_look_at() {
  PlanarOperation<double> op;
  op.about = {.name = "matrix-look-at",
              .title = "building the rotation of a camera from eye, target and up",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 4,
              .reason = "4 u of entries up to 1"};
  op.results = 9;
  op.families = {
      look_at_family("benign", "eye about 1 from the target, up of any direction", 1, 0, 0, false),
      look_at_family("wide", "the same 1000 away from the origin", 1000, 0, 0, false),
      look_at_family("adversarial", "up within 2^-20 to 2^-10 radians of the view axis", 1, -20, -11, true),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    ExactVector<Number> backward, up;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      backward[axis] = Number(in(axis, i)) - in(axis + 3, i);
      up[axis] = in(axis + 6, i);
    }
    const ExactVector<Number> z = unit(backward), x = unit(cross(up, z)), y = cross(z, x);
    for (std::size_t column = 0; column < 3; ++column) {
      results[column] = {x[column], Number(1)};
      results[3 + column] = {y[column], Number(1)};
      results[6 + column] = {z[column], Number(1)};
    }
  });
  op.variants = {
      elementwise64<9>("fp32 cross products", inlined<naive_look_at<float>>),
      elementwise64<9>("fp64 cross products", inlined<naive_look_at<double>>),
      shipped(elementwise64<9>("morphcl, rounded once", inlined<shipped_look_at_rounded>)),
      shipped(elementwise64<9>("morphcl in fp64", inlined<shipped_look_at_in_fp64>)),
  };
  op.compared = 2048;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
