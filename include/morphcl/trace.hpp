// One point on its way through the pipeline, step by step: object -> world -> eye -> clip -> NDC -> viewport -> pixel;
// and back from a pixel to what it shows.
//
// For people who want to see how a picture comes about. Everything is computed in fp64; beside each coordinate stand
// what fp32 makes of it and a bound of the error that it makes.
//
// The bound. A renderer in fp32 rounds the composite M of all steps so far once and applies a row of it as
// fma(x, m0, fma(y, m1, fma(z, m2, m3))). So x m0 meets two roundings, y m1 three, z m2 and m3 four; where the vertex
// is off by e itself, |m| e comes on top:
//
//   |error| <= u (2 |m0 x| + 3 |m1 y| + 4 |m2 z| + 4 |m3|) (1 + 2^-20) + |m| e (1 + 2^-20) + 40 (n + 1) u64 A |p|
//
// u = 2^-24. The last term is what fp64 itself may be off after n steps: A is the product of the steps' matrices with
// the length of its column in place of each entry of the linear part, as entries of rotations are exact to 16u64 of it.
// A quotient q = a / w is off by (e_a + |q| e_w) / (|w| - e_w) and one rounding. Where fp32 would overflow, or cannot
// tell w from 0, the bound is infinite. The bounds hold for the numbers in fp64 and in fp32.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/convention.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/scene.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

enum class TraceSpace { object, world, eye, clip, ndc, viewport };
const char* name_of(TraceSpace space);  // "object"

// A point in homogeneous coordinates, its bound, and what fp32 makes of it. All components are finite but the bound's.
struct TracePoint {
  glm::dvec4 value{0, 0, 0, 1};
  glm::dvec4 bound{0};
  glm::vec4 single{0, 0, 0, 1};
};

// One matrix. Matrices stand as the convention writes them: transposed for row vectors, and then products in the
// opposite order.
struct TraceStep {
  std::string name;    // "rotate_about_axis"
  std::string detail;  // "from (0, 0, 0) to (1, 0, 1), 30 degrees"
  glm::dmat4 matrix{1.0};
  std::optional<glm::dmat4> inverse = {};  // none where the step has none
  glm::dmat4 composite{1.0};               // of all steps from object space on, this one included
  TracePoint point = {};                   // after it
  // The steps that it is made of, each with its own composite and point; empty where it is one by itself, as all are
  // today.
  std::vector<TraceStep> parts = {};
};

// From one space to the next.
struct TraceStage {
  TraceSpace from = TraceSpace::object, to = TraceSpace::world;
  std::string what;                   // "the model transform: 3 steps"
  bool divides = false;               // by w; then there is no matrix
  std::vector<TraceStep> steps = {};  // in the order that the point meets them; empty where it divides
  glm::dmat4 matrix{1.0};             // their product
  std::optional<glm::dmat4> inverse = {};
  glm::dmat4 composite{1.0};  // object space -> here; from NDC on to the homogeneous coordinate, as if not divided
  TracePoint before = {}, after = {};
};

// How a target moves the vertex.
struct TraceTarget {
  std::string name;
  TargetForm form = TargetForm::delta;
  double weight = 0;
  glm::dvec3 value{0.0};  // of the target at this vertex: a difference, or a position
  glm::dvec3 after{0.0};  // the vertex, this target and those before it applied
};

// The plane's pipeline (transform_2d.hpp), beside that of space: for cameras that are orthographic and look along an
// axis of the world, as those of 2-D shots do. Matrices are 3 x 3, points (x, y, 1).
struct TracePlaneStep {
  std::string name, detail;
  glm::dmat3 matrix{1.0}, inverse{1.0}, composite{1.0};
  glm::dvec3 point{0.0};
};
struct TracePlane {
  std::string axes;                   // of the world, that the plane's x and y are: "x, -z"
  glm::dvec2 start{0.0};              // in the world
  std::vector<TracePlaneStep> steps;  // world -> view -> NDC -> viewport
};

// What the renderers have for this point: fp32, snapped to the grid of 1/256 pixel. Vertices alone.
struct TraceRendered {
  glm::vec3 clip{0.0f};  // x, y, w
  float distance = 0;    // along the view axis, from its depth
  glm::ivec2 subpixel{0};
};

struct Trace {
  std::int64_t frame = 0;
  int width = 0, height = 0;
  Convention convention;
  std::string object, mesh;
  std::optional<std::size_t> vertex;  // none for a point of the caller's
  std::size_t vertices = 0;           // of the mesh

  glm::dvec3 base{0.0};  // the vertex before the morph
  std::vector<TraceTarget> targets;
  bool on_springs = false;  // springs, not the weights, say where the vertex is
  TracePoint start;         // in object space

  std::vector<TraceStage> stages;  // up to clip space where the point cannot be divided
  std::vector<std::string> notes;  // in words: what it is outside of, why it goes no further, that up was replaced
  std::optional<double> distance;  // along the view axis
  std::optional<glm::ivec2> pixel;
  std::optional<TraceRendered> rendered;
  std::optional<TracePlane> plane;
};

struct TraceRequest {
  std::string object = {};                         // "": the first
  std::size_t vertex = 0;                          // of its mesh
  std::optional<glm::dvec3> point = std::nullopt;  // in object space instead, morphcl's own convention
  Convention convention = {};
};

// `scene` has passed validate(). Error(usage): an unknown object, naming those there are; a vertex beyond the mesh,
// saying how many it has; a point that is not finite; a scene without objects. Errors of the frame as evaluate().
Trace trace(const Scene& scene, std::int64_t frame, const TraceRequest& request = {});

// ---- back from a pixel ----------------------------------------------------------------------------------------------
//
// Whose triangle or line a pixel's centre shows is what the reference renderer finds there, so it is what the picture
// shows; everything else is computed in fp64 from the corners' clip coordinates (x, y, w), without dividing by w, so
// that corners behind the eye do not matter:
//
//   solve b0 (x0, y0, w0) + b1 (x1, y1, w1) + b2 (x2, y2, w2) = (X, Y, 1) for the pixel's NDC (X, Y)
//
// b_i over their sum are the weights in space, b_i w_i those in the picture, which add up to 1. All of it is in
// morphcl's own convention; `forward` is in the caller's.

struct TraceCorner {
  std::size_t vertex = 0;
  glm::dvec3 position{0.0};  // in object space, morphed
  glm::dvec4 clip{0.0};
  double distance = 0;        // along the view axis
  double picture_weight = 0;  // before the perspective correction
  double weight = 0;          // after it
};

struct PixelTrace {
  glm::ivec2 pixel{0};
  glm::dvec2 centre{0.0}, ndc{0.0};
  glm::dvec3 eye_from{0.0}, eye_along{0.0}, world_from{0.0}, world_along{0.0};  // the ray; in eye space it falls by 1

  std::string object, mesh;
  bool line = false;          // of a wireframe: two corners
  std::size_t primitive = 0;  // triangle or edge of the mesh
  std::vector<TraceCorner> corners;
  bool divisible = true;  // all corners lie in front of the eye; else no mean over the picture makes sense

  bool parallel = false;                                  // projectors: both kinds of weights are the same
  double depth_a = 0, depth_b = 0;                        // perspective: NDC depth = -A - B / z
  glm::dvec3 in_object{0.0}, in_world{0.0}, in_eye{0.0};  // what is hit
  double distance = 0, ndc_depth = 0;
  double mean_distance = 0;     // of the corners by their weights in the picture: wrong in perspective
  double mean_depth = 0;        // NDC depth so, which is right
  float rendered_distance = 0;  // what the renderers have, in fp32
  Trace forward;                // what is hit, on its way back to the pixel
};

// Error(usage): a pixel beyond the picture; one that shows nothing, saying where objects are.
PixelTrace trace_pixel(const Scene& scene, std::int64_t frame, const glm::ivec2& pixel,
                       const Convention& convention = {});

}  // namespace morphcl
#pragma GCC visibility pop
