#include <morphcl/transform.hpp>

bool use_transform() {
  morphcl::CompositeTransform composite;
  composite.translate({1, 2, 3}).scale({2, 2, 2});
  return morphcl::affine_inverse(composite.matrix())[3].x == -1;
}
