#include "bench/peers/llvmpipe/gl_scene.hpp"

#include <cstddef>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "bench/peers/llvmpipe/shader.hpp"

namespace morphcl::bench {

namespace {

struct Vertex {
  glm::vec3 position[2], normal[2];
};

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <class T>
void fill_new_buffer(GLenum target, const std::vector<T>& values) {
  GLuint buffer = 0;
  gl::GenBuffers(1, &buffer);
  gl::BindBuffer(target, buffer);
  gl::BufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

glm::mat4 world_to_clip(const BenchScene& scene) {
  const double aspect = static_cast<double>(scene.width) / scene.height;
  return glm::mat4(glm::perspective(glm::radians(fovy_degrees), aspect, near_plane, far_plane) *
                   glm::lookAt(scene.eye, scene.target, glm::dvec3(0.0, 1.0, 0.0)));
}

glm::mat4 object_to_world(const Placement& placement) {
  return glm::mat4(glm::translate(glm::dmat4(1.0), placement.translation) * glm::mat4_cast(placement.rotation) *
                   glm::scale(glm::dmat4(1.0), glm::dvec3(placement.scale)));
}

}  // namespace

GlScene::GlScene(const BenchScene& scene)
    : mode_(scene.surface == Surface::lines ? GL_LINES : GL_TRIANGLES), blends_(scene.alpha < 1) {
  gl::GenVertexArrays(1, &vertex_array_);
  gl::BindVertexArray(vertex_array_);
  upload_vertices(scene);
  upload_indices(scene);
  if (is_placed(scene)) upload_placements(scene);

  program_ = make_program(scene);
  gl::UseProgram(program_);
  gl::UniformMatrix4fv(gl::GetUniformLocation(program_, "world_to_clip"), 1, GL_FALSE,
                       glm::value_ptr(world_to_clip(scene)));
  const glm::vec3 light = glm::normalize(light_direction);
  gl::Uniform3f(gl::GetUniformLocation(program_, "light"), light.x, light.y, light.z);
  t_ = gl::GetUniformLocation(program_, "t");
  if (scene.surface != Surface::lines) gl::Enable(GL_CULL_FACE);
  gl::ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
}

void GlScene::upload_vertices(const BenchScene& scene) {
  const Shape& shape = scene.shape;
  const bool lit = scene.surface != Surface::lines;
  std::vector<Vertex> vertices(shape.positions[0].size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (int state = 0; state < 2; ++state) {
      vertices[i].position[state] = shape.positions[state][i];
      vertices[i].normal[state] = lit ? shape.normals[state][i] : glm::vec3(0.0f);
    }
  fill_new_buffer(GL_ARRAY_BUFFER, vertices);
  for (GLuint attribute = position_0; attribute <= (lit ? normal_1 : position_1); ++attribute) {
    gl::EnableVertexAttribArray(attribute);
    gl::VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(attribute * sizeof(glm::vec3)));
  }
}

void GlScene::upload_indices(const BenchScene& scene) {
  std::vector<GLuint> indices;
  for (const glm::uvec3& triangle : scene.shape.triangles)
    for (int corner = 0; corner < 3; ++corner) indices.push_back(triangle[corner]);
  for (const glm::uvec2& edge : scene.shape.edges)
    for (int end = 0; end < 2; ++end) indices.push_back(edge[end]);
  indices_ = static_cast<GLsizei>(indices.size());
  if (scene.shape.positions[0].size() <= 65536) {
    index_type_ = GL_UNSIGNED_SHORT;
    fill_new_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<std::uint16_t>(indices.begin(), indices.end()));
  } else {
    fill_new_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  }
}

void GlScene::upload_placements(const BenchScene& scene) {
  std::vector<glm::mat4> matrices;
  for (const Placement& each : scene.placements) matrices.push_back(object_to_world(each));
  instances_ = static_cast<GLsizei>(matrices.size());
  fill_new_buffer(GL_ARRAY_BUFFER, matrices);
  for (GLuint column = 0; column < 4; ++column) {
    gl::EnableVertexAttribArray(placement + column);
    gl::VertexAttribPointer(placement + column, 4, GL_FLOAT, GL_FALSE, sizeof(glm::mat4),
                            offset(column * sizeof(glm::vec4)));
    gl::VertexAttribDivisor(placement + column, 1);
  }
}

void GlScene::draw(float t) const {
  gl::UseProgram(program_);
  gl::BindVertexArray(vertex_array_);
  gl::Enable(GL_DEPTH_TEST);
  if (blends_) {  // premultiplied
    gl::Enable(GL_BLEND);
    gl::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  gl::DepthMask(GL_TRUE);
  gl::Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (blends_) gl::DepthMask(GL_FALSE);  // as usual of what comes sorted, after the opaque
  gl::Uniform1f(t_, t);
  gl::DrawElementsInstanced(mode_, indices_, index_type_, nullptr, instances_);
  gl::Finish();
}

}  // namespace morphcl::bench
