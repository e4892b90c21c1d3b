// An indexed triangle mesh with any number of morph targets.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace morphcl {

// With p of the base and w the weight: a delta target holds differences d, as glTF does, and gives p + w d; an absolute
// target holds values b of its own and gives (1-w) p + w b, exact at w = 0 and w = 1. Several targets add up what they
// change, w d and w (b - p). The form holds for positions, normals and colours.
enum class TargetForm { delta, absolute };

struct MorphTarget {
  std::string name;
  TargetForm form = TargetForm::delta;
  std::vector<glm::vec3> positions;  // one a vertex, or empty: the target does not move vertices
  std::vector<glm::vec3> normals;    // one a vertex, or empty: the base's stay; not used where the mesh has none
  std::vector<glm::vec4> colors;     // the same
};

struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;   // at least one; all finite
  std::vector<glm::vec3> normals;     // one a vertex, unit length, or empty: faces are lit flat
  std::vector<glm::vec4> colors;      // one a vertex, linear RGBA, clamped to [0, 1] after morphing, or empty: white
  std::vector<glm::vec2> uvs;         // one a vertex: texture coordinates, v up (glTF's runs down, 1 - v), or empty
  std::vector<glm::uvec3> triangles;  // indices of vertices, counter-clockwise seen from outside
  std::vector<glm::uvec2>
      edges;  // indices of vertices: what wireframe draws; empty: the distinct edges of the triangles
  std::vector<MorphTarget> targets;
};

// Throws Error(bad_input): an index out of range, an array of the wrong length, NaN or Inf, more than 2^29 triangles or
// 2^31 vertices. The message names the array and the element.
void validate(const Mesh& mesh);

std::vector<glm::uvec2> distinct_edges(
    const std::vector<glm::uvec3>& triangles);  // each once, smaller index first, sorted

// The distinct edges if `edges` is empty, else `edges`.
std::vector<glm::uvec2> wireframe_edges(const Mesh& mesh);

}  // namespace morphcl
#pragma GCC visibility pop
