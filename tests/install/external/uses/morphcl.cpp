#include <morphcl/morphcl.hpp>

bool use_morphcl() { return morphcl::find_solid("no such solid") == nullptr; }
