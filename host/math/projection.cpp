#include "host/math/projection.hpp"

#include <fmt/core.h>

#include <cmath>

#include "host/error.hpp"
#include "host/math/angle.hpp"
#include "host/math/elementary.hpp"
#include "host/math/finite.hpp"

namespace morphcl {

namespace {

[[noreturn]] void refuse(const char* parameter, double value, const char* right) {
  throw Error(ErrorKind::usage, "", fmt::format("{} is {}; it must be {}", parameter, value, right));
}

void require(bool holds, const char* parameter, double value, const char* right) {
  if (!holds) refuse(parameter, value, right);
}

void require_aspect(double aspect) {
  require(aspect > 0 && std::isfinite(aspect), "aspect (width / height)", aspect, "positive and finite");
}

void require_perspective_depths(double near, double far) {
  require(near > 0 && std::isfinite(near), "near", near, "positive and finite");
  require(far > near, "far", far, "greater than near (inf is allowed)");
}

template <typename SixPlanes>
void require_window(const SixPlanes& p) {
  require(std::isfinite(p.left), "left", p.left, "finite");
  require(std::isfinite(p.bottom), "bottom", p.bottom, "finite");
  require(p.right > p.left && std::isfinite(p.right - p.left), "right", p.right, "greater than left and finite");
  require(p.top > p.bottom && std::isfinite(p.top - p.bottom), "top", p.top, "greater than bottom and finite");
}

struct Validator {
  void operator()(const Perspective& p) const {
    require(p.fovy_degrees > 0 && p.fovy_degrees < 180, "fovy_degrees", p.fovy_degrees, "between 0 and 180");
    require_perspective_depths(p.near, p.far);
  }
  void operator()(const Frustum& p) const {
    require_window(p);
    require_perspective_depths(p.near, p.far);
  }
  void operator()(const Orthographic& p) const {
    require_window(p);
    require(std::isfinite(p.near), "near", p.near, "finite");
    require(p.far > p.near && std::isfinite(p.far - p.near), "far", p.far, "greater than near and finite");
  }
};

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

struct MatrixBuilder {
  double aspect;
  bool reversed;

  DepthRow depth(double near, double far) const {
    return reversed ? reversed_perspective_depth(near, far) : perspective_depth(near, far);
  }

  glm::dmat4 operator()(const Perspective& p) const {
    require_aspect(aspect);
    const SinCos half = sin_cos_degrees(0.5 * p.fovy_degrees);
    const double cotangent = half.cos / half.sin;
    return perspective_matrix(cotangent / aspect, cotangent, 0, 0, depth(p.near, p.far));
  }

  glm::dmat4 operator()(const Frustum& p) const {
    return perspective_matrix(2 * p.near / (p.right - p.left), 2 * p.near / (p.top - p.bottom),
                              centre_over_half_width(p.left, p.right), centre_over_half_width(p.bottom, p.top),
                              depth(p.near, p.far));
  }

  glm::dmat4 operator()(const Orthographic& p) const {
    glm::dmat4 m(1.0);
    m[0][0] = 2 / (p.right - p.left);
    m[1][1] = 2 / (p.top - p.bottom);
    m[3][0] = 0.0 - centre_over_half_width(p.left, p.right);
    m[3][1] = 0.0 - centre_over_half_width(p.bottom, p.top);
    const double range = p.far - p.near;
    m[2][2] = reversed ? 1 / range : -2 / range;
    m[3][2] = reversed ? p.far / range : 0.0 - centre_over_half_width(p.near, p.far);
    return m;
  }
};

glm::dmat4 build(const Projection& projection, double aspect, bool reversed) {
  validate(projection);
  const glm::dmat4 matrix = std::visit(MatrixBuilder{aspect, reversed}, projection);
  if (!is_finite(matrix))
    throw Error(ErrorKind::usage, "", "the projection overflows; its planes are too far apart or too close together");
  return matrix;
}

}  // namespace

void validate(const Projection& projection) { std::visit(Validator{}, projection); }

glm::dmat4 projection_matrix(const Projection& projection, double aspect) { return build(projection, aspect, false); }

glm::dmat4 reversed_depth_matrix(const Projection& projection, double aspect) {
  return build(projection, aspect, true);
}

double fovy_from_fovx_degrees(double fovx_degrees, double aspect) {
  require(fovx_degrees > 0 && fovx_degrees < 180, "fovx_degrees", fovx_degrees, "between 0 and 180");
  require_aspect(aspect);
  const SinCos half = sin_cos_degrees(0.5 * fovx_degrees);
  return degrees(2 * quadrant_angle(half.sin, half.cos * aspect));
}

glm::dmat4 central_projection(double eye_z) {
  require(eye_z != 0 && std::isfinite(eye_z), "eye_z", eye_z, "finite and not 0");
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

}  // namespace morphcl
