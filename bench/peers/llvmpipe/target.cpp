#include "bench/peers/llvmpipe/target.hpp"

#include <fmt/format.h>

#include "bench/peers/llvmpipe/shader.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

void attach_renderbuffer(GLenum attachment, GLenum format, int width, int height, int samples) {
  GLuint buffer = 0;
  gl::GenRenderbuffers(1, &buffer);
  gl::BindRenderbuffer(GL_RENDERBUFFER, buffer);
  if (samples > 1)
    gl::RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  else
    gl::RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl::FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

GLuint bind_new_framebuffer() {
  GLuint framebuffer = 0;
  gl::GenFramebuffers(1, &framebuffer);
  gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  return framebuffer;
}

void check_complete(int width, int height, int samples) {
  if (gl::CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ErrorKind::no_device, "",
                fmt::format("OpenGL draws no half RGBA of {} x {} pixels with {} samples", width, height, samples));
}

}  // namespace

RenderTarget::RenderTarget(int width, int height, int samples, bool resolve_by_shader)
    : width_(width),
      height_(height),
      has_several_(samples > 1),
      pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  drawn_ = resolved_ = bind_new_framebuffer();
  if (has_several_ && resolve_by_shader) {
    gl::GenTextures(1, &samples_);
    gl::BindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_);
    gl::TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA16F, width, height, GL_TRUE);
    gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, samples_, 0);
    program_ = make_resolve_program(samples);
    gl::GenVertexArrays(1, &vertices_);
  } else {
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height, samples);
  }
  attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, width, height, samples);
  check_complete(width, height, samples);
  if (has_several_) {
    resolved_ = bind_new_framebuffer();
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height, 1);
    check_complete(width, height, 1);
  }
  gl::Viewport(0, 0, width, height);
  gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
}

void RenderTarget::start_frame() const { gl::BindFramebuffer(GL_FRAMEBUFFER, drawn_); }

void RenderTarget::resolve() const {
  if (program_ == 0) {
    gl::BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    gl::BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl::BindFramebuffer(GL_FRAMEBUFFER, resolved_);
    return;
  }
  gl::BindFramebuffer(GL_FRAMEBUFFER, resolved_);
  gl::Disable(GL_DEPTH_TEST);
  gl::Disable(GL_BLEND);
  gl::UseProgram(program_);
  gl::BindVertexArray(vertices_);
  gl::BindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_);
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

void RenderTarget::read_back() {
  if (has_several_) resolve();
  gl::ReadPixels(0, 0, width_, height_, GL_RGBA, GL_HALF_FLOAT, pixels_.data());
}

}  // namespace morphcl::bench
