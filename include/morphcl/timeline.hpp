// The timeline: everything that moves, and its state at a frame as a pure function of the frame number.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/animated_transform.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/track.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// A node of the hierarchy. node -> parent is translation * rotation * scale * static_transform; a track, where there is
// one, replaces the constant beside it, and steps, where there are any, replace static_transform.
struct Node {
  std::string name;
  int parent = -1;                   // index into Timeline::nodes, -1 for a root
  glm::dmat4 static_transform{1.0};  // a shot's transform steps, or a glTF matrix
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // w x y z
  glm::dvec3 scale{1.0};
  Track translation_track, rotation_track, scale_track;  // width 3, 4 (rotation), 3
  Track visible_track;           // width 1; visible where >= 0.5, and without a track; hides what is below
  AnimatedTransform steps = {};  // a shot's transform steps that move
};

// How the vertices of an object follow its morph when they are masses on springs instead of moving with the weights.
//
// Every vertex is a mass of 1, tied to where the morph wants it (its anchor) and to its neighbours along the edges of
// the triangles; vertices at one place in the base and in all targets are one mass. With d(t) the displacements from
// the base mesh that the weights ask for, y those that the masses have, and r those that the edges want to keep:
//   y'' + D y' + K_edges (y - r) + anchor (y - d) = 0,   D = damping + edge_damping K,   K = anchor + K_edges,
// where K_edges x is, at each mass a, the sum of stiffness (x_a - x_b) over its edges. Up to the first key of its
// weights the object rests in the shape that they ask for. Up to 256 masses whose weights are not on springs move in
// closed form, others in 16 steps of TR-BDF2 a frame; more than 200,000 masses are an Error(bad_input) of the planner.
// Normals and colours follow the weights.

enum class EdgeRest {
  driven,  // r = d: the object arrives at its targets
  base     // r = 0: the edges resist, and the stiffer they are, the further the object stays from its targets
};

enum class EdgeStiffness {
  equal,     // the same for every edge
  by_length  // as for rods of one material: in inverse proportion to the length, `stiffness` at the mean length
};

struct Elastic {
  double anchor = 400;      // 1/s^2: a vertex alone swings with sqrt(anchor) / (2 pi) Hz
  double stiffness = 4000;  // 1/s^2, of an edge
  double damping = 4;       // 1/s, of the velocity
  double edge_damping = 0;  // s, of the stiffness: damps what is stiff more
  EdgeRest rest = EdgeRest::driven;
  EdgeStiffness rule = EdgeStiffness::equal;
};

// The limits: anchor from min_elastic_anchor, stiffness from 0, where every vertex swings alone.
constexpr double min_elastic_anchor = 1e-6, max_elastic_stiffness = 1e16;  // 1/s^2
constexpr double max_elastic_damping = 1e8, max_elastic_edge_damping = 1;  // 1/s, s

// The morph weights of one object. Tracks are applied in order; a later one overrides an earlier one.
struct WeightTrack {
  int first_target = 0;  // the track's width() components drive targets first_target, first_target + 1, ...
  Track track;
  bool operator==(const WeightTrack&) const = default;
};
struct MorphWeights {
  std::vector<double> weights;  // one a target of the object's mesh; the value where no track drives it; not clamped
  std::vector<WeightTrack> tracks;
  std::optional<Elastic> elastic = std::nullopt;  // its vertices follow the weights on springs
};

// Where a camera looks from. With node >= 0 the camera sits in that node's frame looking down its -z (glTF) and
// eye/target/up are not used; scale, shear and mirroring of the node are ignored, so that distances stay the world's.
// With parent >= 0 eye, target, up and their tracks are given in that node's space; what is seen lies where the node
// brings them, and distances stay the world's as well. At most one of the two is set.
struct Camera {
  Projection projection = Perspective{};
  int node = -1, parent = -1;  // indices into Timeline::nodes
  glm::dvec3 eye{0, 0, 5}, target{0, 0, 0}, up{0, 1, 0};
  Track eye_track, target_track, up_track;              // width 3
  Track fovy_track, fovx_track, near_track, far_track;  // width 1; fovy moves Perspective, fovx HorizontalPerspective
};

enum class LightKind { directional, point };

// What makes a point light a spot light: a beam from its position towards `target`. Its light is multiplied by
// c^2, c = (cos a - cos outer) / (cos inner - cos outer) clamped to 0 to 1, a the angle from the beam's axis: all of it
// within the inner cone, nothing outside the outer one (the falloff of glTF's KHR_lights_punctual).
struct SpotBeam {
  glm::dvec3 target{0.0};  // in the space that the light's position is given in
  Track target_track;      // width 3
  // From the axis: 0 <= inner, inner + min_cone_edge_degrees <= outer <= 90.
  double inner_cone_degrees = 0, outer_cone_degrees = 45;
};
constexpr double min_cone_edge_degrees = 0.01;

// A surface's colour is its base colour times its vertex colour times (ambient + the sum over the lights of their
// colour times the cosine of the angle between the normal and the direction to the light, or 0 where that is negative),
// without 1/pi. Nothing casts shadows.
//
// A directional light's `vector` points from the scene towards the light; a point light's is its world position. Colour
// is scene-linear and includes the intensity; a point light does not fall off with distance unless `falloff`. With
// node >= 0 position and direction are given in that node's space, and turn and move with it.
struct Light {
  LightKind kind = LightKind::directional;
  glm::dvec3 vector{0, 0, 1};
  glm::dvec3 color{1.0};
  bool falloff = false;                         // point light: divided by the squared distance in world units
  Track vector_track, color_track;              // width 3
  int node = -1;                                // index into Timeline::nodes
  std::optional<SpotBeam> spot = std::nullopt;  // of a point light
};

struct Timeline {
  TimeBase time;
  std::vector<Node> nodes;  // parents may come in any order; validate() refuses cycles
  Camera camera;
  std::vector<Light> lights;
  glm::dvec3 ambient{0.05};  // scene-linear, lights everything
};

// Error(bad_input): a frame rate out of range, a parent out of range, a cycle (names its nodes), a track of the wrong
// width, a node of the camera or a light out of range, a camera with both node and parent, a constant that is not
// finite, a static_transform that is not affine, a rotation of length 0, a fovy or fovx track on a projection that has
// no such field of view, a degenerate projection (where tracks move it: at the frame).
void validate(const Timeline& timeline);

// Error(bad_input): a weight that is not finite, an Elastic out of its limits, a track that drives targets that do not
// exist or is one of rotations.
void validate(const MorphWeights& morph);

// The weights at a frame, one a target. `morph` has passed validate(). Error(usage) when |frame| > 1,000,000,
// Error(bad_input) when a weight overflows.
std::vector<double> weights_at(const MorphWeights& morph, const TimeBase& time, std::int64_t frame);

struct CameraState {
  Projection projection;
  glm::dmat4 world_to_eye{1.0};
  bool up_replaced = false;  // as LookAt has it (camera.hpp)
};
struct SpotState {
  glm::dvec3 beam;  // world space, unit length, away from the light
  double inner_cone_degrees, outer_cone_degrees;
};
struct LightState {
  LightKind kind;
  glm::dvec3 vector;  // world space; directional: unit length, towards the light; point: position
  glm::dvec3 color;
  bool falloff;
  std::optional<SpotState> spot = std::nullopt;
};
struct FrameState {
  std::int64_t frame = 0;
  std::vector<glm::dmat4> node_to_world;  // of each node, by its index
  std::vector<char> node_visible;         // not 0: the node and all above it are visible
  CameraState camera;
  std::vector<LightState> lights;
  glm::dvec3 ambient{0.05};
};

// `timeline` has passed validate(). Error(usage) when |frame| > 1,000,000. Error(bad_input), naming the frame, where
// the motion itself goes wrong: eye meets target, a projection or a light's direction degenerates, a spot light meets
// what it shines at, a transform overflows.
FrameState evaluate(const Timeline& timeline, std::int64_t frame);

}  // namespace morphcl
#pragma GCC visibility pop
