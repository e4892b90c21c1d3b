# Everything that misuse.cpp numbers is refused by the compiler, and what stands beside it is not.
#
# cmake -D COMPILER=... -D INCLUDE=... -P check_misuse.cmake
set(command ${COMPILER} -std=c++20 -Iprecompiled -I${INCLUDE})
# GCC takes a precompiled header where it looks for the header; others pass it over.
file(MAKE_DIRECTORY precompiled/morphcl)
execute_process(COMMAND ${command} -x c++-header ${INCLUDE}/morphcl/morphcl.hpp -o precompiled/morphcl/morphcl.hpp.gch
                ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/misuse.cpp cases REGEX "MISUSE == ")
foreach(line IN LISTS cases)
  string(REGEX REPLACE ".*MISUSE == ([0-9]+).*" "\\1" number "${line}")
  execute_process(COMMAND ${command} -fsyntax-only -DMISUSE=${number} ${CMAKE_CURRENT_LIST_DIR}/misuse.cpp
                  RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(number EQUAL 0 AND NOT result EQUAL 0)
    message(FATAL_ERROR "what is right does not compile:\n${errors}")
  elseif(number GREATER 0 AND result EQUAL 0)
    message(FATAL_ERROR "compiles and must not: ${line}")
  endif()
endforeach()
