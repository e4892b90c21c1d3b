#include "bench/peers/llvmpipe/context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <malloc.h>

#include <cstdlib>

#include "bench/peers/llvmpipe/gl.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::no_device, "", what + "; it needs Mesa's EGL and llvmpipe (libegl1, libgl1-mesa-dri)");
}

// llvmpipe allocates and frees tens of MB a frame: kept pages spare it a tenth of the time on large meshes.
void keep_freed_pages() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 64 << 20);
}

std::string gl_text(GLenum name) {
  const GLubyte* text = gl::GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

void make_llvmpipe_context(int threads) {
  keep_freed_pages();
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 1);

  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("no surfaceless EGL display");
  if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL has no OpenGL");
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (!eglChooseConfig(display, config_attributes, &config, 1, &found) || found == 0) fail("no EGL configuration");
  const EGLint context_attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
  if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    fail("no OpenGL 3.3 context");
  gl::load_functions();
  if (renderer_name().find("llvmpipe") == std::string::npos) fail("OpenGL is drawn by " + renderer_name());
}

std::string renderer_name() { return gl_text(GL_RENDERER) + ", " + gl_text(GL_VERSION); }

}  // namespace morphcl::bench
