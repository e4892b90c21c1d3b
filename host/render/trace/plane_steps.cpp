#include "host/render/trace/plane_steps.hpp"

#include <fmt/format.h>

#include <cmath>

#include "morphcl/camera.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/transform_2d.hpp"

namespace morphcl {

namespace {

struct PlaneOfView {
  PrincipalView view;
  const char* axes;
};
constexpr PlaneOfView planes_of_views[] = {{PrincipalView::front, "x, y"},  {PrincipalView::back, "-x, y"},
                                           {PrincipalView::right, "-z, y"}, {PrincipalView::left, "z, y"},
                                           {PrincipalView::top, "x, -z"},   {PrincipalView::bottom, "x, z"}};

// The direction towards the eye, in the world.
glm::dvec3 towards_eye(const glm::dmat4& world_to_eye) {
  return {world_to_eye[0][2], world_to_eye[1][2], world_to_eye[2][2]};
}

class PlaneChain {
 public:
  PlaneChain(VectorForm form, const glm::dvec2& point, TracePlane& plane)
      : form_(form), point_(point, 1), plane_(plane) {
    plane.start = point;
  }

  void add(TracePlaneStep step, const glm::dmat3& matrix) {
    composite_ = matrix * composite_;
    point_ = matrix * point_;
    step.matrix = written(matrix);
    step.inverse = written(affine_inverse(matrix));
    step.composite = written(composite_);
    step.point = point_;
    plane_.steps.push_back(std::move(step));
  }

 private:
  glm::dmat3 written(const glm::dmat3& m) const { return form_ == VectorForm::row ? glm::transpose(m) : m; }

  VectorForm form_;
  glm::dmat3 composite_{1.0};
  glm::dvec3 point_;
  TracePlane& plane_;
};

}  // namespace

void trace_plane(const CameraState& camera, const glm::dvec3& world, Trace& trace) {
  const auto* const planes = std::get_if<Orthographic>(&camera.projection);
  if (planes == nullptr) return;
  for (const PlaneOfView& plane : planes_of_views) {
    const glm::dmat4 to_plane = world_to_eye(plane.view);
    if (towards_eye(to_plane) != towards_eye(camera.world_to_eye)) continue;
    trace.plane.emplace();
    trace.plane->axes = plane.axes;
    const glm::dmat4 eye_to_world = rigid_inverse(camera.world_to_eye);
    const glm::dvec2 centre(to_plane * eye_to_world[3]), right(to_plane * eye_to_world[0]);
    const double turn = degrees(arc_tangent(right.y, right.x));
    const auto width = static_cast<double>(trace.width), height = static_cast<double>(trace.height);
    const Window window = fitted_window(camera.projection, width / height).window;
    PlaneChain chain(trace.convention.vectors, glm::dvec2(to_plane * glm::dvec4(world, 1)), *trace.plane);
    chain.add({"world -> view",
               fmt::format("centre ({:.6g}, {:.6g}), axes turned by {:.6g} degrees", centre.x, centre.y, turn)},
              world_to_view(centre, turn));
    chain.add({"view -> NDC", fmt::format("clipping window x {:.6g} to {:.6g}, y {:.6g} to {:.6g}", window.left,
                                          window.right, window.bottom, window.top)},
              view_to_ndc(window));
    chain.add({"NDC -> viewport", fmt::format("{} x {} pixels, y downwards", trace.width, trace.height)},
              ndc_to_pixels({0, 0, width, height}));
    return;
  }
}

}  // namespace morphcl
