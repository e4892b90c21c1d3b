// The plan of a frame: what has to be done for this scene at this frame with these options, and what is left out and
// why.
//
// Everything that needs fp64 or trigonometry happens here; what the renderers get is rounded to fp32 once, the same for
// device and reference.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "anim/timeline.hpp"
#include "host/scene/scene.hpp"

namespace morphcl {

// Row-major rows of an affine or projective map: row r gives component r = ((m[3] + z m[2]) + y m[1]) + x m[0] by fma.
using Row = std::array<float, 4>;

struct ActiveTarget {
  int target;         // index into the mesh's targets
  float weight;       // the target's factor
  float base_weight;  // the base's factor: -weight for an absolute target, 0 for a delta
};

struct Draw {
  const Mesh* mesh = nullptr;
  Shading shading = Shading::flat;
  bool double_sided = false;
  bool mirrored = false;              // the object's transform has a negative determinant: front faces turn clockwise
  std::array<Row, 4> object_to_clip;  // rows x, y, depth, w
  std::array<Row, 3> object_to_eye;   // for lighting: positions
  std::array<std::array<float, 3>, 3> normal_to_eye;  // inverse transpose, scaled by a power of two
  std::array<float, 4> base_color;
  bool vertex_colors = false;
  std::vector<ActiveTarget> targets;  // only those with a weight other than 0
};

struct EyeLight {
  LightKind kind;
  std::array<float, 3> vector;  // eye space: unit direction towards the light, or position
  std::array<float, 3> color;
  bool falloff;
};

struct PlanNote {
  std::string item;    // "normals"
  bool done;           // false: left out
  std::string reason;  // "no lights in the scene"
};

struct FramePlan {
  std::uint64_t planner =
      0;  // which planner made it: plans of one planner share their meshes, which then do not change
  std::int64_t frame = 0;
  int width = 0, height = 0;
  bool color = true, depth = true;
  std::vector<Draw> draws;
  std::vector<EyeLight> lights;
  std::array<float, 3> ambient{};
  bool parallel = false;              // orthographic: w is 1 everywhere
  std::array<float, 3> near_plane{};  // distance in front of it: [0] depth row + [1] w row + [2]; 0 or more is drawn
  float near_w = 1;                   // w on the near plane
  float near_depth = 0;               // depth on the near plane; larger depths are nearer
  float far_depth = 0;                // depth on the far plane: smaller ones are not drawn
  float near = 0;                     // perspective: Z = near / depth; parallel: Z = -depth
  bool clips = true;                  // false: nothing comes near a clip plane, the clip stage is left out
  bool divides = true;                // false: w is 1 at every vertex, nothing is divided by it
  bool tests_depth = true;            // false: no pixel centre is covered twice, what comes is not compared
  bool keeps_vertices = true;         // a draw that is as it was in the frame drawn before keeps its vertices
  bool keeps_blank_tiles = true;      // tiles that were and stay background are not written again
  // Eye position of a pixel for point lights, from its centre (x, y) and its distance d along the axis:
  // (x * ray[0] + ray[1]) * (parallel ? 1 : d) and so on for y with ray[2], ray[3].
  std::array<float, 4> ray{};
  glm::dmat4 world_to_eye{1.0}, world_to_ndc{1.0};  // for the image's attributes
  std::vector<PlanNote> notes;
};

// Plans frames of one scene; keeps what does not change from frame to frame (the bounds of every mesh). The scene must
// outlive the planner and its plans, which refer to the scene's meshes, and must not change meanwhile. A renderer keeps
// the meshes of one planner on the device: frames of one scene are planned by one planner.
class Planner {
 public:
  explicit Planner(const Scene& scene);
  ~Planner();
  // Error(bad_input) naming the frame when its camera or a transform is degenerate or leaves fp32.
  FramePlan plan(std::int64_t frame) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// For a single frame: Planner(scene).plan(frame).
FramePlan plan_frame(const Scene& scene, std::int64_t frame);

}  // namespace morphcl
