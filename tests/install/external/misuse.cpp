// What must not compile: one case for each number that MISUSE can be. With 0 everything does.
#include <morphcl/morphcl.hpp>

using namespace morphcl;

namespace {
Scene make_scene() { return {}; }
}  // namespace

void misuse() {
  [[maybe_unused]] const glm::dmat4 affine(1.0);
  [[maybe_unused]] const glm::mat4 single(1.0f);
  [[maybe_unused]] const glm::dvec3 point(0.0);
  [[maybe_unused]] const TimeBase time;
  [[maybe_unused]] const Scene scene;
#if MISUSE == 0
  affine_inverse(affine);
  Transform<float>::points(affine);
  Track::linear(time, {{0, 0.0}, {10, 1.0}});
  const Planner planner(scene);
#elif MISUSE == 1  // GLM would turn one matrix into another
  affine_inverse(single);
#elif MISUSE == 2
  affine_inverse(glm::dmat3x4(1.0));
#elif MISUSE == 3
  to_fp32(single);
#elif MISUSE == 4
  Transform<float>::points(single);
#elif MISUSE == 5
  Transform<double>::project(glm::dmat3(1.0));
#elif MISUSE == 6  // GLM would drop z
  orientation(point, point, point);
#elif MISUSE == 7
  CompositeTransform2d().translate(point);
#elif MISUSE == 8   // keys of different kinds
  Track::linear(time, {{0, 0.0}, {10, glm::dvec3(1.0)}});
#elif MISUSE == 9   // rotations have no tangents
  Track::cubic(time, std::vector<RotationKey>{});
#elif MISUSE == 10  // the scene is gone before its planner is used
  const Planner planner(make_scene());
#elif MISUSE == 11
  plan_frame(make_scene(), 0);
#elif MISUSE == 12  // vertices of another precision
  transform_reference(Transform<float>::points(affine), Vertices<const double>::xyz({}), Vertices<double>::xyz({}));
#elif MISUSE == 13  // results into memory that is only read
  Vertices<double> results = Vertices<const double>::xyz({});
#elif MISUSE == 14
  make_reference_renderer()->render(plan_frame(scene, 0), FrameBuffer(1, 1, {Channel::color, Channel::depth}));
#elif MISUSE == 15
  decompose(single);
#endif
}
