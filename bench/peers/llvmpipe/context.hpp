// An OpenGL context without a window, drawn by Mesa's llvmpipe.
#pragma once

#include <string>

namespace morphcl::bench {

// Makes an OpenGL 3.3 core context current in this process, for good, and loads the functions of gl.hpp. llvmpipe gets
// `threads` threads beside the one that calls it; 1 means none beside it. Must run before anything else of Mesa.
// Error(no_device) when there is no such context or something other than llvmpipe would draw.
void make_llvmpipe_context(int threads);

// "llvmpipe (LLVM ...), Mesa ...": who draws.
std::string renderer_name();

}  // namespace morphcl::bench
