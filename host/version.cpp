#include "morphcl/version.hpp"

namespace morphcl {

#define MORPHCL_TEXT_OF(number) #number
#define MORPHCL_TEXT(number) MORPHCL_TEXT_OF(number)

const char* version() {
  return MORPHCL_TEXT(MORPHCL_VERSION_MAJOR) "." MORPHCL_TEXT(MORPHCL_VERSION_MINOR) "." MORPHCL_TEXT(
      MORPHCL_VERSION_PATCH);
}

}  // namespace morphcl
