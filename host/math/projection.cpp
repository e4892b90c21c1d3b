#include "morphcl/projection.hpp"

#include <fmt/core.h>

#include <cmath>

#include "host/math/finite.hpp"
#include "host/math/require_number.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

void require_aspect(double aspect) {
  require_number(aspect > 0 && std::isfinite(aspect), "aspect (width / height)", aspect, "positive and finite");
}

// z_clip = scale * z_eye + offset.
struct DepthRow {
  double scale, offset;
};

// Depth -1 at near, 1 at far. Quotients come before products so that near = 1e-300 and far = 1e300 do not overflow.
DepthRow perspective_depth(double near, double far) {
  if (std::isinf(far)) return {-1.0, -2 * near};
  const double range = far - near;
  return {-(far / range + near / range), -2 * near * (far / range)};
}

// Depth 1 at near, 0 at far.
DepthRow reversed_perspective_depth(double near, double far) {
  if (std::isinf(far)) return {0.0, near};
  const double range = far - near;
  return {near / range, near * (far / range)};
}

// (high + low) / (high - low), the sum halved so that it cannot overflow.
double centre_over_half_width(double low, double high) { return (0.5 * high + 0.5 * low) / (0.5 * high - 0.5 * low); }

glm::dmat4 perspective_matrix(double x_scale, double y_scale, double x_shift, double y_shift, const DepthRow& depth) {
  glm::dmat4 m(0.0);
  m[0][0] = x_scale;
  m[1][1] = y_scale;
  m[2][0] = x_shift;
  m[2][1] = y_shift;
  m[2][2] = depth.scale;
  m[3][2] = depth.offset;
  m[2][3] = -1;
  return m;
}

double cotangent_of_half(double degrees) {
  const SinCos half = sin_cos_degrees(0.5 * degrees);
  return half.cos / half.sin;
}

template <typename Planes>
Window window_of(const Planes& p) {
  return {p.left, p.right, p.bottom, p.top};
}

struct MatrixBuilder {
  double aspect;
  bool reversed;

  DepthRow depth(double near, double far) const {
    return reversed ? reversed_perspective_depth(near, far) : perspective_depth(near, far);
  }

  // `distance`: of the plane that the window is measured on.
  glm::dmat4 through(const Window& w, double distance, const DepthRow& depth) const {
    return perspective_matrix(2 * distance / (w.right - w.left), 2 * distance / (w.top - w.bottom),
                              centre_over_half_width(w.left, w.right), centre_over_half_width(w.bottom, w.top), depth);
  }

  template <typename Planes>
  glm::dmat4 parallel(const Planes& p) const {
    const Window w = fitted(window_of(p), p.fit, aspect).window;
    glm::dmat4 m(1.0);
    m[0][0] = 2 / (w.right - w.left);
    m[1][1] = 2 / (w.top - w.bottom);
    m[3][0] = 0.0 - centre_over_half_width(w.left, w.right);
    m[3][1] = 0.0 - centre_over_half_width(w.bottom, w.top);
    const double range = p.far - p.near;
    m[2][2] = reversed ? 1 / range : -2 / range;
    m[3][2] = reversed ? p.far / range : 0.0 - centre_over_half_width(p.near, p.far);
    return m;
  }

  glm::dmat4 operator()(const Perspective& p) const {
    const double cotangent = cotangent_of_half(p.fovy_degrees);
    return perspective_matrix(cotangent / aspect, cotangent, 0, 0, depth(p.near, p.far));
  }

  glm::dmat4 operator()(const HorizontalPerspective& p) const {
    const double cotangent = cotangent_of_half(p.fovx_degrees);
    return perspective_matrix(cotangent, cotangent * aspect, 0, 0, depth(p.near, p.far));
  }

  glm::dmat4 operator()(const Frustum& p) const {
    return through(fitted(window_of(p), p.fit, aspect).window, p.near, depth(p.near, p.far));
  }

  glm::dmat4 operator()(const CentralProjection& p) const {
    return through(fitted(window_of(p), p.fit, aspect).window, p.board, depth(p.near, p.far));
  }

  glm::dmat4 operator()(const Orthographic& p) const { return parallel(p); }

  // x moves by shear.x * (-z - plane), y likewise: the centre of the window moves the other way.
  glm::dmat4 operator()(const Oblique& p) const {
    glm::dmat4 m = parallel(p);
    const double shear[2] = {p.shear.x, p.shear.y};
    for (int axis = 0; axis < 2; ++axis) {
      m[2][axis] = 0.0 - m[axis][axis] * shear[axis];
      m[3][axis] = std::fma(m[2][axis], p.plane, m[3][axis]) + 0.0;
    }
    return m;
  }
};

struct WindowFinder {
  double aspect;

  FittedWindow operator()(const Perspective& p) const {
    const double y = 1 / cotangent_of_half(p.fovy_degrees), x = y * aspect;
    return {{-x, x, -y, y}};
  }
  FittedWindow operator()(const HorizontalPerspective& p) const {
    const double x = 1 / cotangent_of_half(p.fovx_degrees), y = x / aspect;
    return {{-x, x, -y, y}};
  }
  template <typename Planes>
  FittedWindow operator()(const Planes& p) const {
    return fitted(window_of(p), p.fit, aspect);
  }
};

glm::dmat4 build(const Projection& projection, double aspect, bool reversed) {
  validate(projection);
  require_aspect(aspect);
  const glm::dmat4 matrix = std::visit(MatrixBuilder{aspect, reversed}, projection);
  if (!is_finite(matrix))
    throw Error(ErrorKind::usage, "", "the projection overflows; its planes are too far apart or too close together");
  return matrix;
}

}  // namespace

glm::dmat4 projection_matrix(const Projection& projection, double aspect) { return build(projection, aspect, false); }

glm::dmat4 reversed_depth_matrix(const Projection& projection, double aspect) {
  return build(projection, aspect, true);
}

double fovy_from_fovx_degrees(double fovx_degrees, double aspect) {
  require_number(fovx_degrees > 0 && fovx_degrees < 180, "fovx_degrees", fovx_degrees, "between 0 and 180");
  require_aspect(aspect);
  const SinCos half = sin_cos_degrees(0.5 * fovx_degrees);
  return degrees(2 * arc_tangent(half.sin, half.cos * aspect));
}

glm::dmat4 central_projection(double eye_z) {
  require_number(eye_z != 0 && std::isfinite(eye_z), "eye_z", eye_z, "finite and not 0");
  glm::dmat4 m(0.0);
  m[0][0] = m[1][1] = m[2][2] = eye_z;
  m[2][3] = -1;
  m[3][3] = eye_z;
  return m;
}

double near_distance(const Projection& projection) {
  return std::visit([](const auto& p) { return p.near; }, projection);
}

double far_distance(const Projection& projection) {
  return std::visit([](const auto& p) { return p.far; }, projection);
}

FittedWindow fitted_window(const Projection& projection, double aspect) {
  validate(projection);
  require_aspect(aspect);
  return std::visit(WindowFinder{aspect}, projection);
}

}  // namespace morphcl
