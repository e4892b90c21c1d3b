#include <morphcl/transform_2d.hpp>

bool use_transform_2d() { return morphcl::CompositeTransform2d().translate({1, 2}).matrix()[2].y == 2; }
