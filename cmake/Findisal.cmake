# ISA-L (libisal-dev)
include(${CMAKE_CURRENT_LIST_DIR}/MorphclFindLibrary.cmake)
morphcl_find_library(isal isa-l/igzip_lib.h isal)
