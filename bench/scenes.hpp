// The scenes of the benchmarks, in a plain form that every program that is compared draws from.
//
// One shape, in one or many places, is mixed from its state at t = 0 to its state at t = 1. One white directional light
// and Lambert's law: colour = base_color * max(cos, 0) + ambient. Background 0 with alpha 0.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

namespace morphcl::bench {

inline constexpr glm::dvec3 base_color{0.8, 0.5, 0.3};       // scene-linear
inline constexpr double ambient = 0.05;                      // added to each channel of what is lit
inline constexpr glm::dvec3 light_direction{0.4, 0.7, 0.9};  // towards the light; any length
inline constexpr double fovy_degrees = 45.0, near_plane = 0.1, far_plane = 100.0;

enum class Surface {
  flat,    // one colour a triangle
  smooth,  // normals interpolated and normalised a pixel
  lines,   // the edges, one pixel wide, white and unlit
};

// State 0 is t = 0, state 1 is t = 1.
struct Shape {
  std::vector<glm::vec3> positions[2];
  // Directions of any length, one a vertex; none for lines. Of a flat shape they are chosen so that the mixed direction
  // is the exact face normal at every t.
  std::vector<glm::vec3> normals[2];
  std::vector<glm::uvec3> triangles;  // counter-clockwise seen from outside
  std::vector<glm::uvec2> edges;      // of lines; else empty
};

struct Placement {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  double scale = 1.0;
};

struct BenchScene {
  std::string name;
  int width = 1920, height = 1080;  // pixels
  int frames = 24;                  // how many are timed unless the caller asks for another number
  Surface surface = Surface::flat;
  double alpha = 1.0;  // less: triangles are blended, and come sorted from the farthest to the nearest
  Shape shape;
  std::vector<Placement> placements{1};
  glm::dvec3 eye{0.0}, target{0.0, 0.0, -1.0};  // up is y
};

// Whether a placement moves, turns or scales the shape at all.
bool is_placed(const BenchScene& scene);

// In the order of the tables. "crowd" and "crowd_in_view" are of the series only: cubes of which one in a hundred is in
// view, and just those.
const std::vector<std::string>& scene_names();

// `width` and `height` 0: the scene's own size. `amount`: how many there are of what the scene has many of, triangles
// (heavy: the next grid's), layers (overdraw, blended) or cubes (many, crowd); 0: the scene's own number. Error(usage)
// for an unknown name, and for an amount out of the scene's range.
BenchScene make_bench_scene(const std::string& name, int width, int height, int amount);

}  // namespace morphcl::bench
