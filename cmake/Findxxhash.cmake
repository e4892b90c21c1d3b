# xxHash (libxxhash-dev)
include(${CMAKE_CURRENT_LIST_DIR}/MorphclFindLibrary.cmake)
morphcl_find_library(xxhash xxhash.h xxhash)
