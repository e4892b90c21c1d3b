#include <morphcl/numerics.hpp>

bool use_numerics() { return morphcl::from_half(morphcl::to_half(morphcl::cosine(0))) == 1; }
