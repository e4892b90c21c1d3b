// The shaders: morph, place and project in the vertex shader, Lambert's law a pixel.
#pragma once

#include "bench/peers/llvmpipe/gl.hpp"
#include "bench/scenes.hpp"

namespace morphcl::bench {

// Attribute locations of the vertex shader.
enum Attribute : GLuint { position_0, position_1, normal_0, normal_1, placement };  // placement: a mat4, 4 locations

// A linked program with uniforms mat4 world_to_clip, vec3 light, float t. A flat surface has its normal once a
// triangle; a scene whose shape is not placed has no placement matrix. Error(internal) with the compiler's log.
GLuint make_program(const BenchScene& scene);

// A linked program that draws three vertices without attributes: the mean of the samples of the texture in unit 0.
GLuint make_resolve_program(int samples);

}  // namespace morphcl::bench
