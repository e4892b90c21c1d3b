// One object of a frame as the renderers get it.
#pragma once

#include "host/render/plan.hpp"

namespace morphcl {

// The parts of a frame that all its draws share.
struct DrawContext {
  const Scene& scene;
  const FramePlan& plan;  // its lights and ambient light
  bool keeps_idle_targets, keeps_normals;
};

// `weights`: one a target of the object's mesh. Error(usage) when a number does not fit into fp32.
Draw make_draw(const DrawContext& context, std::size_t object, const glm::dmat4& object_to_eye,
               const glm::dmat4& object_to_clip, const std::vector<double>& weights);

}  // namespace morphcl
