#include <morphcl/projection.hpp>

bool use_projection() { return morphcl::is_parallel(morphcl::Orthographic{-1, 1, -1, 1, 0, 1}); }
