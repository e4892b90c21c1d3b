# The library target morphcl::morphcl: all parts in one archive, installable and found by find_package(morphcl).
#
# Headers keep their paths: #include <host/render/plan.hpp>; <morphcl/morphcl.hpp> brings the whole library.
include(CMakePackageConfigHelpers)

# External target -> how its package is found again by who uses an installed morphcl. "private": nothing of it is in a
# header of morphcl, so it is needed for linking only, or not at all when it is header-only.
set(MORPHCL_PACKAGE_Threads::Threads "find_dependency(Threads)")
set(MORPHCL_PACKAGE_OpenCL::OpenCL "find_dependency(OpenCL)")
set(MORPHCL_PACKAGE_OpenCL::HeadersCpp "find_dependency(OpenCLHeadersCpp)")
set(MORPHCL_PACKAGE_glm::glm "find_dependency(glm)")
set(MORPHCL_PACKAGE_OpenEXR::OpenEXR "find_dependency(OpenEXR)")
set(MORPHCL_PACKAGE_PNG::PNG "find_dependency(PNG)")
set(MORPHCL_PACKAGE_fmt::fmt "find_dependency(fmt)")
set(MORPHCL_PACKAGE_nlohmann_json::nlohmann_json "private")
set(MORPHCL_PACKAGE_Eigen3::Eigen "private")
set(MORPHCL_PACKAGE_tomlplusplus::tomlplusplus "find_dependency(tomlplusplus)")
set(MORPHCL_PACKAGE_PkgConfig::xxhash
    "find_dependency(PkgConfig)\npkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)")
foreach(library IN ITEMS libdeflate libisal)
  set(MORPHCL_PACKAGE_PkgConfig::${library}
      "find_dependency(PkgConfig)\npkg_check_modules(${library} REQUIRED IMPORTED_TARGET ${library})")
endforeach()

# What the parts together link outside the library, and the lines that find it.
get_property(parts GLOBAL PROPERTY morphcl_parts)
set(external "")
foreach(part IN LISTS parts)
  get_target_property(links ${part} INTERFACE_LINK_LIBRARIES)
  foreach(link IN LISTS links)
    if(link MATCHES "^(morphcl_|\\$<LINK_ONLY:)" OR NOT link)
      continue()
    endif()
    list(APPEND external ${link})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES external)
set(objects "")
foreach(part IN LISTS parts)
  list(APPEND objects $<TARGET_OBJECTS:${part}>)
endforeach()

add_library(morphcl STATIC ${objects})
add_library(morphcl::morphcl ALIAS morphcl)
set_target_properties(morphcl PROPERTIES LINKER_LANGUAGE CXX)
target_compile_features(morphcl INTERFACE cxx_std_20)
target_include_directories(morphcl INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/morphcl>)

set(MORPHCL_FIND_DEPENDENCIES "")
foreach(link IN LISTS external)
  if(NOT DEFINED MORPHCL_PACKAGE_${link})
    message(FATAL_ERROR "${link} is linked by the library; tell cmake/MorphclInstall.cmake how to find it")
  elseif(MORPHCL_PACKAGE_${link} STREQUAL "private")
    target_link_libraries(morphcl INTERFACE $<BUILD_INTERFACE:${link}>)
  else()
    target_link_libraries(morphcl INTERFACE ${link})
    string(APPEND MORPHCL_FIND_DEPENDENCIES "${MORPHCL_PACKAGE_${link}}\n")
  endif()
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/morphcl)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/morphclConfig.cmake.in ${PROJECT_BINARY_DIR}/morphclConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/morphclConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/morphclConfig.cmake ${PROJECT_BINARY_DIR}/morphclConfigVersion.cmake
        DESTINATION ${package_dir})
install(TARGETS morphcl EXPORT morphclTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT morphclTargets NAMESPACE morphcl:: DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/host ${PROJECT_SOURCE_DIR}/anim DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/morphcl
        FILES_MATCHING PATTERN "*.hpp")
install(FILES ${PROJECT_SOURCE_DIR}/kernels/camera.h ${PROJECT_SOURCE_DIR}/kernels/layout.h
        ${PROJECT_SOURCE_DIR}/kernels/transform_kind.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/morphcl/kernels)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/morphcl DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/demos/ DESTINATION ${CMAKE_INSTALL_DATADIR}/morphcl/demos
        FILES_MATCHING PATTERN "*.toml" PATTERN "*.gltf" PATTERN "viewer" EXCLUDE)
