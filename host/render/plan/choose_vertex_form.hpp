// The cheapest form of a draw's vertices that keeps them within the error that a scene states.
#pragma once

#include "host/geometry/bounds.hpp"
#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// Of the frame, beside the draw.
struct VertexSetting {
  const glm::dmat4 &eye_to_clip, &world_to_eye, &object_to_world;
  const MorphBounds& mesh;
  const std::vector<double>& weights;  // of all targets
  double pixels;                       // the error stated
};

// Sets draw.accuracy, and turns the draw's matrices and weights into those of the form chosen. The draw is complete but
// for that. Where no form is within the error, it gets the one of the least bound.
void choose_vertex_form(const VertexSetting& setting, const FramePlan& plan, Draw& draw);

}  // namespace morphcl
