#include <morphcl/rotation.hpp>

bool use_rotation() { return morphcl::axis_rotation({0, 0, 1}, 90).matrix[0].y == 1; }
