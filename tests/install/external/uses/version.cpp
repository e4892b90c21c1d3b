#include <morphcl/version.hpp>

bool use_version() { return morphcl::version()[0] >= '0' && MORPHCL_VERSION_MAJOR >= 0; }
