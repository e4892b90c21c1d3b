// Where the peer draws: half RGBA and 32-bit float depth, with one or several samples a pixel, and how the pixels come
// back to the host.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/peers/llvmpipe/gl.hpp"

namespace morphcl::bench {

class RenderTarget {
 public:
  // Several samples become one by a blit, or by a shader. Error(no_device) when OpenGL refuses size, format or number.
  RenderTarget(int width, int height, int samples, bool resolve_by_shader);

  // What is drawn from then on is drawn here.
  void start_frame() const;

  // Waits for what was drawn and reads half RGBA, four halves a pixel, bottom row first.
  void read_back();
  const std::vector<std::uint16_t>& pixels() const { return pixels_; }

 private:
  void resolve() const;

  int width_, height_;
  bool has_several_;
  GLuint drawn_ = 0, resolved_ = 0;                  // framebuffers; the same one where a pixel has one sample
  GLuint program_ = 0, vertices_ = 0, samples_ = 0;  // of the shader: program, vertex array, texture; else 0
  std::vector<std::uint16_t> pixels_;
};

}  // namespace morphcl::bench
