# What every target of the project shares.

# The same arithmetic everywhere: no contraction of a*b+c into fma, no reassociation (docs/conventions.md).
add_library(morphcl_options INTERFACE)
target_compile_options(morphcl_options INTERFACE -ffp-contract=off)
# GCC 12 takes the rounding out of two doubles side by side that are rounded to float and back, once it has made a vector
# of them: p[0] = float(p[0]), p[1] = float(p[1]) does nothing at -O2 and -O3. Its vectors of loops are right. It stands
# behind the flags of who builds the library, and is off for every version: tests/rounding holds each against it.
target_compile_options(morphcl_options INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-slp-vectorize>)

add_library(morphcl_warnings INTERFACE)
target_compile_options(morphcl_warnings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
                                                  $<$<BOOL:${MORPHCL_WARNINGS_AS_ERRORS}>:-Werror>)
# GCC 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651).
target_compile_options(morphcl_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# GCC 12 takes vector = {a, b} for a copy from beyond the list, once it has put all of it into one function.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(morphcl_warnings INTERFACE -Wno-array-bounds -Wno-stringop-overread -Wno-stringop-overflow)
endif()
# In a unity build GCC takes sources for headers, whose types must not lean on unnamed namespaces.
target_compile_options(morphcl_warnings INTERFACE
                       $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
# Clang 19 takes what libstdc++ 12's stable_sort calls for a deprecated call of ours; GCC's own warning stays.
target_compile_options(morphcl_warnings INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)

if(MORPHCL_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_compile_options(morphcl_options INTERFACE ${sanitizers})
  target_link_options(morphcl_options INTERFACE ${sanitizers})
  target_sources(morphcl_options INTERFACE
                 $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/cmake/driver_leaks.cpp>)
  # GCC 12 takes its own checks in the standard library's <regex> for uses of uninitialized values.
  target_compile_options(morphcl_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

# The arrows between rooms: room -> rooms that it may include, from cmake/rooms.txt.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/rooms.txt)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/rooms.txt room_lines REGEX "^[^#]")
foreach(line IN LISTS room_lines)
  string(REGEX MATCH "^([^:]+): *([^|]*[^| ])?( [|].*)?$" matched "${line}")
  string(REPLACE " " ";" included "${CMAKE_MATCH_2}")
  set(MORPHCL_ROOM_${CMAKE_MATCH_1} "${included}")
endforeach()

# host/render/plan -> morphcl_render_plan
function(morphcl_room_target room target_var)
  string(REGEX REPLACE "^host/" "" name "${room}")
  string(REPLACE "/" "_" name "${name}")
  set(${target_var} morphcl_${name} PARENT_SCOPE)
endfunction()

# morphcl_embed_kernels(OUTPUT_VAR FUNCTION name DECLARED_IN header): a source file with the *.cl of the caller's folder, as
# EmbedKernels.cmake makes it. They may include headers of kernels/.
function(morphcl_embed_kernels output_var)
  cmake_parse_arguments(EMBED "" "FUNCTION;DECLARED_IN" "" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cl ${CMAKE_CURRENT_SOURCE_DIR}/*.h
       ${PROJECT_SOURCE_DIR}/kernels/*.h)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/kernel_sources.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -D FOLDER=${folder} -D HEADERS=kernels
            -D COMPILER=${CMAKE_C_COMPILER} -D DECLARED_IN=${EMBED_DECLARED_IN} -D FUNCTION=${EMBED_FUNCTION}
            -D OUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/cmake/EmbedKernels.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/EmbedKernels.cmake
    COMMENT "Embedding ${folder}"
    VERBATIM)
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # lint reads what is unity, before the build
  set(${output_var} ${output} PARENT_SCOPE)
endfunction()

# morphcl_add_room([SOURCES ...] [PACKAGES ...]): the folder of the caller, all its .cpp files and what the build makes
# (SOURCES). It may include the rooms that rooms.txt allows and the PACKAGES.
function(morphcl_add_room)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PACKAGES" ${ARGN})
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  if(NOT DEFINED MORPHCL_ROOM_${room})
    message(FATAL_ERROR "cmake/rooms.txt does not name ${room}")
  endif()
  morphcl_room_target(${room} target)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(${target} STATIC ${sources} ${ROOM_SOURCES})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  foreach(included IN LISTS MORPHCL_ROOM_${room})
    morphcl_room_target(${included} link)
    target_link_libraries(${target} PUBLIC ${link})
  endforeach()
  target_link_libraries(${target} PUBLIC ${ROOM_PACKAGES} PRIVATE morphcl_options morphcl_warnings)
  if(NOT room MATCHES "^lab/")
    set_property(GLOBAL APPEND PROPERTY morphcl_parts ${target})
  endif()
endfunction()
