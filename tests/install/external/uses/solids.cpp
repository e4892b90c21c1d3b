#include <morphcl/solids.hpp>

bool use_solids() { return morphcl::make_solid("cube").triangles.size() == 12; }
