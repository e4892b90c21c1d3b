// The version of the headers, and of the library that is linked.
#pragma once

#define MORPHCL_VERSION_MAJOR 0
#define MORPHCL_VERSION_MINOR 2
#define MORPHCL_VERSION_PATCH 0

#pragma GCC visibility push(default)
namespace morphcl {

// Of the library: "0.2.0". Frames and kernels that another version made are not taken for this one's.
const char* version();

}  // namespace morphcl
#pragma GCC visibility pop
