# libdeflate (libdeflate-dev)
include(${CMAKE_CURRENT_LIST_DIR}/MorphclFindLibrary.cmake)
morphcl_find_library(libdeflate libdeflate.h deflate)
