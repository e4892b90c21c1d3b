#include <morphcl/batch.hpp>

bool use_batch() {
  const auto moved = morphcl::Transform<float>::points(morphcl::CompositeTransform().translate({1, 2, 3}));
  std::array<float, 6> points{0, 0, 0, 1, 1, 1};
  const auto vertices = morphcl::Vertices<float>::xyz(points);
  morphcl::transform_reference(moved, vertices, vertices);
  return points[5] == 4;
}
