# Installs the build BINARY_DIR below a fresh temporary folder, builds a project of somebody else's against it with
# find_package, runs that program and the installed tool. Nothing of the build or source tree is used after the install.
#
# cmake -D BINARY_DIR=... -D SOURCE_DIR=... -D VERSION=... -D COMPILERS=... -D GENERATOR=... -P install_test.cmake
if(DEFINED ENV{TMPDIR})
  set(temporary $ENV{TMPDIR})
else()
  set(temporary /tmp)
endif()
string(RANDOM LENGTH 12 name)
set(folder ${temporary}/morphcl-install-${name})
set(prefix ${folder}/prefix)

# Runs a command in the folder; removes the folder and stops when it fails.
function(step)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    file(REMOVE_RECURSE ${folder})
    message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${folder})
file(COPY ${SOURCE_DIR}/tests/install/external ${SOURCE_DIR}/demos/first_program.cpp DESTINATION ${folder})
file(RENAME ${folder}/first_program.cpp ${folder}/external/first_program.cpp)
step(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix})
foreach(compiler IN LISTS COMPILERS)
  step(${CMAKE_COMMAND} -S external -B build -G ${GENERATOR} --fresh
       -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${prefix} -D HEADERS=${prefix}/include/morphcl
       -D MORPHCL_VERSION=${VERSION})
  step(${CMAKE_COMMAND} --build build)
  step(build/use_headers)
endforeach()
step(build/first_program)
step(${prefix}/bin/morphcl info first.0100.exr)
step(${prefix}/bin/morphcl plan ${prefix}/share/morphcl/demos/pyramid_to_cube.toml --frame 57)
file(REMOVE_RECURSE ${folder})
