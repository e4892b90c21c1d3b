// One object of a frame as the renderers get it.
#pragma once

#include <cstdint>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/plan/draw_ids.hpp"

namespace morphcl {

// The parts of a frame that all its draws share.
struct DrawContext {
  const Scene& scene;
  const FramePlan& plan;                  // its lights and ambient light
  const std::vector<bool>& vertex_alpha;  // see meshes_with_alpha()
  const DrawIds& ids;
  bool keeps_normals;
  std::int64_t tick;  // of the frame
};

// All of a draw but its targets. Error(usage) when a number does not fit into fp32.
void make_draw(const DrawContext& context, std::size_t object, const glm::dmat4& object_to_eye,
               const glm::dmat4& object_to_clip, Draw& draw);

// Replaces the draw's targets. `weights`: one a target of its mesh. Error(usage) when one does not fit into fp32.
void set_targets(const std::vector<double>& weights, bool keeps_idle, Draw& draw);

}  // namespace morphcl
