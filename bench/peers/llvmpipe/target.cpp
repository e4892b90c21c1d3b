#include "bench/peers/llvmpipe/target.hpp"

#include <fmt/format.h>

#include "bench/peers/llvmpipe/gl.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

void attach_renderbuffer(GLenum attachment, GLenum format, int width, int height) {
  GLuint buffer = 0;
  gl::GenRenderbuffers(1, &buffer);
  gl::BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl::RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl::FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

}  // namespace

RenderTarget::RenderTarget(int width, int height)
    : width_(width), height_(height), pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  GLuint framebuffer = 0;
  gl::GenFramebuffers(1, &framebuffer);
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height);
  attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height);
  if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ErrorKind::no_device, "", fmt::format("OpenGL draws no half RGBA of {} x {} pixels", width, height));
  gl::Viewport(0, 0, width, height);
  gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
}

void RenderTarget::read_back() { gl::ReadPixels(0, 0, width_, height_, GL_RGBA, GL_HALF_FLOAT, pixels_.data()); }

}  // namespace morphcl::bench
