# MPFR (libmpfr-dev)
include(${CMAKE_CURRENT_LIST_DIR}/MorphclFindLibrary.cmake)
morphcl_find_library(mpfr mpfr.h mpfr)
