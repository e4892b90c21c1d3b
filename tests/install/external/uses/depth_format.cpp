#include <morphcl/depth_format.hpp>

bool use_depth_format() {
  return morphcl::depth_format_named(morphcl::name_of(morphcl::DepthFormat::fixed24)) == morphcl::DepthFormat::fixed24;
}
