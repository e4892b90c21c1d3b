#include "bench/peers/llvmpipe/gl.hpp"

#include <EGL/egl.h>

#include "morphcl/error.hpp"

namespace morphcl::bench::gl {

#define MORPHCL_PEER_DEFINE(Type, Name) Type Name = nullptr;
MORPHCL_PEER_GL_FUNCTIONS(MORPHCL_PEER_DEFINE)
#undef MORPHCL_PEER_DEFINE

namespace {

template <class Function>
void load(Function& function, const char* name) {
  function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (!function) throw Error(ErrorKind::no_device, "", std::string("OpenGL has no ") + name + "; 3.3 is needed");
}

}  // namespace

void load_functions() {
#define MORPHCL_PEER_LOAD(Type, Name) load(Name, "gl" #Name);
  MORPHCL_PEER_GL_FUNCTIONS(MORPHCL_PEER_LOAD)
#undef MORPHCL_PEER_LOAD
}

}  // namespace morphcl::bench::gl
