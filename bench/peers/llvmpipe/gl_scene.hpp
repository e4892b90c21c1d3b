// A benchmark scene in OpenGL: vertices of both states interleaved, indices, one matrix a placement, drawn by one
// instanced call.
#pragma once

#include "bench/peers/llvmpipe/gl.hpp"
#include "bench/scenes.hpp"

namespace morphcl::bench {

class GlScene {
 public:
  // Uploads everything and sets all state that does not change from frame to frame. A context is current.
  explicit GlScene(const BenchScene& scene);

  // Clears and draws the state at t, and waits until it is drawn.
  void draw(float t) const;

 private:
  void upload_vertices(const BenchScene& scene);
  void upload_indices(const BenchScene& scene);
  void upload_placements(const BenchScene& scene);

  GLuint vertex_array_ = 0, program_ = 0;
  GLenum mode_ = GL_TRIANGLES, index_type_ = GL_UNSIGNED_INT;
  GLsizei indices_ = 0, instances_ = 1;
  GLint t_ = -1;
  bool blends_ = false;
};

}  // namespace morphcl::bench
