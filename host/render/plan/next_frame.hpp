// Where the draws of a frame are in the next one: what velocity is made from.
#pragma once

#include <vector>

#include "anim/node_sampler.hpp"
#include "host/geometry/bounds.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/draw_ids.hpp"
#include "host/render/plan/elastic_shapes.hpp"
#include "host/render/plan/shared_weights.hpp"

namespace morphcl {

// For one thread at a time. The scene, the bounds of its meshes and the ids outlive it.
class NextFrame {
 public:
  NextFrame(const Scene& scene, const std::vector<MorphBounds>& meshes, const DrawIds& ids)
      : scene_(scene),
        meshes_(meshes),
        ids_(ids),
        nodes_(scene.timeline.nodes),
        weights_(scene),
        opaque_(meshes.size()) {}

  // Sets plan.next_draws and which of its draws move; all else of the plan is complete. Matrices, morph targets and
  // displaced positions are those of the frame with the next number, whichever is drawn after this one. `elastic` is
  // asked for the shapes of that frame.
  void add_to(FramePlan& plan, bool keeps_idle_targets, ElasticShapes& elastic);

 private:
  const Scene& scene_;
  const std::vector<MorphBounds>& meshes_;
  const DrawIds& ids_;
  NodeSampler nodes_;
  SharedWeights weights_;
  const std::vector<bool> opaque_;  // alpha moves no vertex
};

}  // namespace morphcl
