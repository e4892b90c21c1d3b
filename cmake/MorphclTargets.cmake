# What every target of the project shares.

# The same arithmetic everywhere: no contraction of a*b+c into fma, no reassociation (docs/conventions.md).
add_library(morphcl_options INTERFACE)
target_compile_options(morphcl_options INTERFACE -ffp-contract=off)

add_library(morphcl_warnings INTERFACE)
target_compile_options(morphcl_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
                                                  $<$<BOOL:${MORPHCL_WARNINGS_AS_ERRORS}>:-Werror>)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
target_compile_options(morphcl_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

if(MORPHCL_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_compile_options(morphcl_options INTERFACE ${sanitizers})
  target_link_options(morphcl_options INTERFACE ${sanitizers})
  target_sources(morphcl_options INTERFACE
                 $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/cmake/driver_leaks.cpp>)
  # GCC 12 takes its own checks in the standard library's <regex> for uses of uninitialized values.
  target_compile_options(morphcl_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# morphcl_add_part(NAME SOURCES... [LINKS ...]): one folder of the library. LINKS names the parts and
# packages that this folder may include.
function(morphcl_add_part name)
  cmake_parse_arguments(PART "" "" "LINKS" ${ARGN})
  add_library(morphcl_${name} STATIC ${PART_UNPARSED_ARGUMENTS})
  target_include_directories(morphcl_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(morphcl_${name} PUBLIC ${PART_LINKS} PRIVATE morphcl_options morphcl_warnings)
  set_property(GLOBAL APPEND PROPERTY morphcl_parts morphcl_${name})
endfunction()
