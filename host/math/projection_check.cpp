// What makes a projection degenerate.
#include <cmath>

#include "host/math/require_number.hpp"
#include "morphcl/projection.hpp"

namespace morphcl {

namespace {

void require_field_of_view(const char* name, double degrees) {
  require_number(degrees > 0 && degrees < 180, name, degrees, "between 0 and 180");
}

void require_perspective_depths(double near, double far) {
  require_number(near > 0 && std::isfinite(near), "near", near, "positive and finite");
  require_number(far > near, "far", far, "greater than near (inf is allowed)");
}

void require_parallel_depths(double near, double far) {
  require_number(std::isfinite(near), "near", near, "finite");
  require_number(far > near && std::isfinite(far - near), "far", far, "greater than near and finite");
}

template <typename SixPlanes>
void require_window(const SixPlanes& p) {
  require_number(std::isfinite(p.left), "left", p.left, "finite");
  require_number(std::isfinite(p.bottom), "bottom", p.bottom, "finite");
  require_number(p.right > p.left && std::isfinite(p.right - p.left), "right", p.right, "greater than left and finite");
  require_number(p.top > p.bottom && std::isfinite(p.top - p.bottom), "top", p.top, "greater than bottom and finite");
}

struct Validator {
  void operator()(const Perspective& p) const {
    require_field_of_view("fovy_degrees", p.fovy_degrees);
    require_perspective_depths(p.near, p.far);
  }
  void operator()(const HorizontalPerspective& p) const {
    require_field_of_view("fovx_degrees", p.fovx_degrees);
    require_perspective_depths(p.near, p.far);
  }
  void operator()(const Frustum& p) const {
    require_window(p);
    require_perspective_depths(p.near, p.far);
  }
  void operator()(const CentralProjection& p) const {
    require_window(p);
    require_perspective_depths(p.near, p.far);
    require_number(p.board > 0 && std::isfinite(p.board), "board", p.board, "positive and finite");
  }
  void operator()(const Orthographic& p) const {
    require_window(p);
    require_parallel_depths(p.near, p.far);
  }
  void operator()(const Oblique& p) const {
    require_window(p);
    require_parallel_depths(p.near, p.far);
    // A factor at the limit may be rounded beyond it when it is taken apart into x and y.
    const double factor = std::sqrt(p.shear.x * p.shear.x + p.shear.y * p.shear.y);
    require_number(factor <= max_oblique_factor * (1 + 1e-15), "the oblique factor", factor,
                   "at most 57.29 (projectors at 1 degree to the picture's plane)");
    require_number(std::isfinite(p.plane), "plane", p.plane, "finite");
  }
};

}  // namespace

void validate(const Projection& projection) { std::visit(Validator{}, projection); }

}  // namespace morphcl
