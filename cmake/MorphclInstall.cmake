# The library target morphcl::morphcl: all parts in one archive, installable and found by find_package(morphcl).
get_property(parts GLOBAL PROPERTY morphcl_parts)
set(objects "")
foreach(part IN LISTS parts)
  list(APPEND objects $<TARGET_OBJECTS:${part}>)
endforeach()
add_library(morphcl STATIC ${objects})
add_library(morphcl::morphcl ALIAS morphcl)
