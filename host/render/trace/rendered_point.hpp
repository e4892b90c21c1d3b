// What the renderers have for a vertex.
#pragma once

#include "host/render/frame/scene_vertices.hpp"
#include "morphcl/trace.hpp"

namespace morphcl {

// Of the draws of a plan that leaves nothing out; null for an object that is not drawn at this frame.
const Draw* find_draw(const FramePlan& plan, std::size_t object);

// Nothing where the vertex is outside of what is drawn without clipping.
std::optional<TraceRendered> rendered_vertex(const FramePlan& plan, const Draw& draw, std::size_t vertex);

// Along the view axis, of a depth as the renderers have it.
float distance_of(const FramePlan& plan, float depth);

}  // namespace morphcl
