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
  color = vec4(BASE_COLOR * max(dot(normalize(normal), light), 0.0) + AMBIENT, 1.0) * ALPHA;
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

GLuint link(const std::string& vertex, const std::string& fragment) {
  const GLuint program = gl::CreateProgram();
  gl::AttachShader(program, compile(GL_VERTEX_SHADER, vertex));
  gl::AttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
  gl::LinkProgram(program);
  GLint linked = GL_FALSE;
  gl::GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) throw Error(ErrorKind::internal, "program", log_of(program, gl::GetProgramiv, gl::GetProgramInfoLog));
  return program;
}

// A triangle over the picture, and the mean of the samples.
constexpr const char* resolve_vertex_source = R"(
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";
constexpr const char* resolve_fragment_source = R"(
layout(location = 0) out vec4 color;
uniform sampler2DMS samples;
void main() {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < SAMPLES; i++) sum += texelFetch(samples, ivec2(gl_FragCoord.xy), i);
  color = sum / float(SAMPLES);
}
)";

}  // namespace

GLuint make_program(const BenchScene& scene) {
  std::string head = "#version 330 core\n";
  if (scene.surface != Surface::lines) head += "#define LIT\n";
  if (is_placed(scene)) head += "#define PLACED\n";
  head += fmt::format("#define INTERPOLATION {}\n", scene.surface == Surface::flat ? "flat" : "smooth");
  head += fmt::format("#define ALPHA {:.3f}\n", scene.alpha);
  head += fmt::format("#define BASE_COLOR vec3({}, {}, {})\n#define AMBIENT {}\n", base_color.r, base_color.g,
                      base_color.b, ambient);
  return link(head + vertex_source, head + fragment_source);
}

GLuint make_resolve_program(int samples) {
  const std::string head = fmt::format("#version 330 core\n#define SAMPLES {}\n", samples);
  return link(head + resolve_vertex_source, head + resolve_fragment_source);
}

}  // namespace morphcl::bench
