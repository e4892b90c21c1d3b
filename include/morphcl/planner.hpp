// Plans frames: what has to be done for this scene at this frame with these options, and what is left out and why.
#pragma once

#include <cstdint>
#include <memory>

#include "morphcl/plan.hpp"
#include "morphcl/scene.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// What plans may leave out. Every picture is the same with and without; measurements and tests ask for both. (But an
// object out of view whose transform leaves fp32 is an error only where it is not left out.)
struct PlanOptions {
  bool leave_out = true;  // false: nothing is left out, whatever the items say
  bool objects_out_of_view = true;
  bool idle_targets = true;   // morph targets of weight 0
  bool normals = true;        // and light, where the scene has no lights; and all colour, where none is asked for
  bool clipping = true;       // where nothing reaches the near plane or far beyond the picture
  bool divide = true;         // by w, where it is 1: in parallel projections
  bool depth_test = true;     // where no pixel is covered twice
  bool kept_vertices = true;  // transforming objects that are as in the frame drawn before
  bool blank_tiles = true;    // writing tiles of 64 x 64 pixels that were background and stay so
};

// Plans frames of one scene; keeps what does not change from frame to frame: bounds of meshes, transforms of nodes that
// stand still, and for every object a box that holds it at all times, so that a frame costs what is in view. Of what is
// not in view nothing is evaluated. The scene must outlive the planner and its plans, which refer to the scene's
// meshes, and must not change meanwhile. A renderer keeps the meshes of one planner on the device: frames of one scene
// are planned by one planner. Threads may share a planner; they take turns.
class Planner {
 public:
  // Error(usage), with what validate() says, for a scene that is not valid.
  explicit Planner(const Scene& scene, const PlanOptions& options = {});
  explicit Planner(const Scene&& scene, const PlanOptions& options = {}) = delete;  // it would be gone before its plans
  ~Planner();

  // A pure function of the frame's number. Error(bad_input) naming the frame when its camera or the transform of an
  // object in view is degenerate or leaves fp32. Error(usage) when |frame| > 1,000,000.
  Plan plan(std::int64_t frame) const;

  const Scene& scene() const;
  const PlanOptions& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// For a single frame. Any renderer draws it, whatever it drew before. Errors as those of Planner.
Plan plan_frame(const Scene& scene, std::int64_t frame, const PlanOptions& options = {});
Plan plan_frame(const Scene&& scene, std::int64_t frame, const PlanOptions& options = {}) = delete;

}  // namespace morphcl
#pragma GCC visibility pop
