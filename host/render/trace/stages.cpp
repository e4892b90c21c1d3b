#include "host/render/trace/stages.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "host/math/finite.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// The convention's handedness and depth, written in columns.
Convention in_columns(Convention convention) {
  convention.vectors = VectorForm::column;
  return convention;
}

struct ProjectionWords {
  std::string operator()(const Perspective& p) const {
    return fmt::format("perspective, fovy {:.6g} degrees, near {:.6g}, far {:.6g}", p.fovy_degrees, p.near, p.far);
  }
  std::string operator()(const HorizontalPerspective& p) const {
    return fmt::format("perspective, fovx {:.6g} degrees, near {:.6g}, far {:.6g}", p.fovx_degrees, p.near, p.far);
  }
  std::string operator()(const Frustum& p) const { return "frustum, " + planes(p); }
  std::string operator()(const CentralProjection& p) const {
    return fmt::format("central projection onto a board {:.6g} in front of the eye, {}", p.board, planes(p));
  }
  std::string operator()(const Orthographic& p) const { return "orthographic, " + planes(p); }
  std::string operator()(const Oblique& p) const {
    return fmt::format("oblique, shear ({:.6g}, {:.6g}), {}", p.shear.x, p.shear.y, planes(p));
  }

  double aspect;

  template <class Planes>
  std::string planes(const Planes& p) const {
    const Window w = fitted_window(p, aspect).window;
    return fmt::format("window x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, near {:.6g}, far {:.6g}", w.left, w.right,
                       w.bottom, w.top, p.near, p.far);
  }
};

// The product of a stage's steps, written as they are.
glm::dmat4 product(const std::vector<TraceStep>& steps, VectorForm form) {
  glm::dmat4 all(1.0);
  for (const TraceStep& step : steps) all = form == VectorForm::row ? all * step.matrix : step.matrix * all;
  return all;
}

std::optional<glm::dmat4> product_of_inverses(const std::vector<TraceStep>& steps, VectorForm form) {
  glm::dmat4 all(1.0);
  for (const TraceStep& step : steps) {
    if (!step.inverse) return std::nullopt;
    all = form == VectorForm::row ? *step.inverse * all : all * *step.inverse;
  }
  if (!is_finite(all)) return std::nullopt;
  return all;
}

void close(TraceStage& stage, const TracePoint& before, VectorForm form, const StepChain& chain) {
  stage.before = before;
  stage.after = chain.point();
  stage.matrix = product(stage.steps, form);
  stage.inverse = product_of_inverses(stage.steps, form);
  stage.composite = chain.composite();
}

// The inverse of x' = a x + c z, y' = b y + d z, z' = A z + B, w' = e z with e 1 or -1.
std::optional<glm::dmat4> perspective_inverse(const glm::dmat4& m) {
  const double e = m[2][3];
  glm::dmat4 inverse(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    inverse[axis][axis] = 1 / m[axis][axis];
    inverse[3][axis] = 0.0 - e * m[2][axis] / m[axis][axis];
  }
  inverse[3][2] = e;
  inverse[2][3] = 1 / m[3][2];
  inverse[3][3] = 0.0 - e * m[2][2] / m[3][2];
  if (!is_finite(inverse)) return std::nullopt;
  return inverse;
}

}  // namespace

std::optional<glm::dmat4> pipeline_inverse(const glm::dmat4& matrix) {
  const bool affine = matrix[0][3] == 0 && matrix[1][3] == 0 && matrix[2][3] == 0 && matrix[3][3] == 1;
  return affine ? try_affine_inverse(matrix) : perspective_inverse(matrix);
}

TracePoint handed(const Convention& convention, TracePoint point) {
  if (convention.handedness == Handedness::left) {
    point.value.z = -point.value.z;
    point.single.z = -point.single.z;
  }
  return point;
}

TraceStage model_stage(const std::vector<TransformStep>& steps, const Convention& convention, StepChain& chain) {
  TraceStage stage{TraceSpace::object, TraceSpace::world, "the object's transform steps place it"};
  const TracePoint before = chain.point();
  const Convention columns = in_columns(convention);
  for (const TransformStep& step : steps) {
    std::optional<glm::dmat4> inverse;
    if (step.invertible) inverse = transform_to(columns, step.inverse);
    stage.steps.push_back(chain.add(step.name, step.detail, transform_to(columns, step.matrix), inverse));
  }
  if (steps.empty()) {
    stage.what = "the object stands as it is: object space is world space";
    stage.steps.push_back(chain.add("identity", "no transform", glm::dmat4(1.0), glm::dmat4(1.0)));
  }
  close(stage, before, convention.vectors, chain);
  return stage;
}

TraceStage view_stage(const CameraState& camera, const Convention& convention, StepChain& chain) {
  TraceStage stage{TraceSpace::world, TraceSpace::eye, "the camera becomes the origin, its axes become the axes"};
  const TracePoint before = chain.point();
  const Convention columns = in_columns(convention);
  const glm::dmat4 eye_to_world = rigid_inverse(camera.world_to_eye);
  const glm::dvec3 eye(eye_to_world[3]);
  glm::dmat4 move(1.0), back(1.0);
  move[3] = glm::dvec4(0.0 - eye, 1.0);
  back[3] = glm::dvec4(eye, 1.0);
  const glm::dmat4 turn(glm::dmat3(camera.world_to_eye)), turn_back = glm::transpose(turn);
  const double z_sign = convention.handedness == Handedness::left ? -1 : 1;
  stage.steps.push_back(chain.add(
      "translate", fmt::format("the eye ({:.6g}, {:.6g}, {:.6g}) to the origin", eye.x, eye.y, z_sign * eye.z),
      transform_to(columns, move), transform_to(columns, back)));
  stage.steps.push_back(chain.add("turn the axes",
                                  convention.vectors == VectorForm::row
                                      ? "columns: right, up and the view axis; the inverse is the transpose"
                                      : "rows: right, up and the view axis; the inverse is the transpose",
                                  transform_to(columns, turn), transform_to(columns, turn_back)));
  close(stage, before, convention.vectors, chain);
  return stage;
}

TraceStage projection_stage(const Projection& projection, double aspect, const Convention& convention,
                            StepChain& chain) {
  TraceStage stage{TraceSpace::eye, TraceSpace::clip, "the projection, without its division"};
  const TracePoint before = chain.point();
  const glm::dmat4 matrix = projection_to(in_columns(convention), projection_matrix(projection, aspect)).matrix;
  stage.steps.push_back(
      chain.add("project", std::visit(ProjectionWords{aspect}, projection), matrix, pipeline_inverse(matrix)));
  close(stage, before, convention.vectors, chain);
  return stage;
}

TraceStage division_stage(const TracePoint& clip, const TracePoint& ndc, const StepChain& chain) {
  TraceStage stage{TraceSpace::clip, TraceSpace::ndc, "each coordinate is divided by w"};
  stage.divides = true;
  stage.composite = chain.composite();
  stage.before = clip;
  stage.after = ndc;
  return stage;
}

TraceStage viewport_stage(int width, int height, const TracePoint& ndc, const Convention& convention,
                          const StepChain& chain) {
  TraceStage stage{TraceSpace::ndc, TraceSpace::viewport, "the window becomes the picture, y downwards"};
  const double half_width = 0.5 * width, half_height = 0.5 * height;
  const bool half_depth = convention.depth == NdcDepth::minus_one_to_one;
  const glm::dvec3 scale(half_width, -half_height, half_depth ? 0.5 : 1),
      shift(half_width, half_height, half_depth ? 0.5 : 0);
  glm::dmat4 matrix(1.0), inverse(1.0);
  for (int i = 0; i < 3; ++i) {
    matrix[i][i] = scale[i];
    matrix[3][i] = shift[i];
    inverse[i][i] = 1 / scale[i];
    inverse[3][i] = 0.0 - shift[i] / scale[i];
  }
  TraceStep step{"viewport", fmt::format("{} x {} pixels; depth from 0 at near to 1 at far", width, height),
                 chain.written(matrix), chain.written(inverse)};
  step.composite =
      convention.vectors == VectorForm::row ? chain.composite() * step.matrix : step.matrix * chain.composite();
  step.point = scaled(ndc, scale, shift);
  stage.matrix = step.matrix;
  stage.inverse = step.inverse;
  stage.composite = step.composite;
  stage.before = ndc;
  stage.after = step.point;
  stage.steps.push_back(std::move(step));
  return stage;
}

}  // namespace morphcl
