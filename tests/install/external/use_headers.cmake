# use_headers(target headers library): a program with a source file for each header in the folder `headers`, which includes
# that one alone, under strict warnings, and calls what it declares.
function(use_headers target headers library)
  file(GLOB names RELATIVE ${headers} ${headers}/*)
  set(declarations "")
  set(calls "")
  foreach(header IN LISTS names)
    string(REPLACE ".hpp" "" name ${header})
    string(APPEND declarations "bool use_${name}();\n")
    string(APPEND calls "  if (!use_${name}()) wrong = \"${name}\";\n")
    list(APPEND uses ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/uses/${name}.cpp)
  endforeach()
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp "#include <cstdio>\n\n${declarations}\nint main() {\n"
       "  const char* wrong = \"\";\n${calls}  std::puts(wrong);\n  return *wrong ? 1 : 0;\n}\n")
  add_executable(${target} ${uses} ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Werror)
  target_link_libraries(${target} PRIVATE ${library})
endfunction()
