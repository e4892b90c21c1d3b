#include "bench/peers/llvmpipe/shader.hpp"

#include <fmt/format.h>

#include <string>

#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

constexpr const char* vertex_source = R"(
layout(location = 0) in vec3 position_0;
layout(location = 1) in vec3 position_1;
#ifdef LIT
layout(location = 2) in vec3 normal_0;
layout(location = 3) in vec3 normal_1;
INTERPOLATION out vec3 normal;
#endif
#ifdef PLACED
layout(location = 4) in mat4 object_to_world;
#endif
uniform mat4 world_to_clip;
uniform float t;

void main() {
  vec4 position = vec4(mix(position_0, position_1, t), 1.0);
#ifdef PLACED
  position = object_to_world * position;
#endif
  gl_Position = world_to_clip * position;
#ifdef LIT
  vec3 direction = mix(normal_0, normal_1, t);
#ifdef PLACED
  direction = mat3(object_to_world) * direction;
#endif
  normal = normalize(direction);
#endif
}
)";

constexpr const char* fragment_source = R"(
layout(location = 0) out vec4 color;
#ifdef LIT
INTERPOLATION in vec3 normal;
uniform vec3 light;
#endif

void main() {
#ifdef LIT
  color = vec4(BASE_COLOR * max(dot(normalize(normal), light), 0.0) + AMBIENT, 1.0);
#else
  color = vec4(1.0);
#endif
}
)";

std::string log_of(GLuint object, PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC get_log) {
  GLint length = 0;
  get(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  get_log(object, length, nullptr, log.data());
  return log;
}

GLuint compile(GLenum stage, const std::string& source) {
  const GLuint shader = gl::CreateShader(stage);
  const char* text = source.c_str();
  gl::ShaderSource(shader, 1, &text, nullptr);
  gl::CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl::GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) throw Error(ErrorKind::internal, "shader", log_of(shader, gl::GetShaderiv, gl::GetShaderInfoLog));
  return shader;
}

}  // namespace

GLuint make_program(const BenchScene& scene) {
  std::string head = "#version 330 core\n";
  if (scene.surface != Surface::lines) head += "#define LIT\n";
  if (is_placed(scene)) head += "#define PLACED\n";
  head += fmt::format("#define INTERPOLATION {}\n", scene.surface == Surface::flat ? "flat" : "smooth");
  head += fmt::format("#define BASE_COLOR vec3({}, {}, {})\n#define AMBIENT {}\n", base_color.r, base_color.g,
                      base_color.b, ambient);
  const GLuint program = gl::CreateProgram();
  gl::AttachShader(program, compile(GL_VERTEX_SHADER, head + vertex_source));
  gl::AttachShader(program, compile(GL_FRAGMENT_SHADER, head + fragment_source));
  gl::LinkProgram(program);
  GLint linked = GL_FALSE;
  gl::GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw Error(ErrorKind::internal, "program", log_of(program, gl::GetProgramiv, gl::GetProgramInfoLog));
  return program;
}

}  // namespace morphcl::bench
