# Everything that misuse.cpp numbers is refused by the compiler, and what stands beside it is not.
#
# cmake -D COMPILER=... -D INCLUDE=... -P check_misuse.cmake
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/misuse.cpp cases REGEX "MISUSE == ")
foreach(line IN LISTS cases)
  string(REGEX REPLACE ".*MISUSE == ([0-9]+).*" "\\1" number "${line}")
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -I${INCLUDE} -DMISUSE=${number} ${CMAKE_CURRENT_LIST_DIR}/misuse.cpp
                  RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(number EQUAL 0 AND NOT result EQUAL 0)
    message(FATAL_ERROR "what is right does not compile:\n${errors}")
  elseif(number GREATER 0 AND result EQUAL 0)
    message(FATAL_ERROR "compiles and must not: ${line}")
  endif()
endforeach()
