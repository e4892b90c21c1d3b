#include <morphcl/visibility.hpp>

bool use_visibility() {
  return morphcl::visibility_method_named(morphcl::name_of(morphcl::VisibilityMethod::bsp)) ==
         morphcl::VisibilityMethod::bsp;
}
