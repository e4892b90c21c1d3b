// Proves, where it is true, that no pixel of a frame is covered by two triangles: then nothing is hidden behind
// anything, and renderers need not compare depths.
#pragma once

#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// Only for frames of one single-sided draw of few triangles of which nothing is clipped; of
// others nothing is proved. Where true, no pixel's depth reaches the far plane either, so it needs no comparison at
// all.
//
// Method: vertices are projected and snapped to sub-pixels with the renderers' arithmetic; from here on everything is
// exact in integers. Triangles that show their back, or have no area, are not drawn. The others turn the same way
// round, so how many of them cover a point is how often their boundary - the edges that are left when edges run through
// in both directions cancel - winds around it. When every boundary edge runs counter-clockwise as seen from one point,
// and they wind around that point once, each ray from it meets the boundary once: no point is wound around twice. A
// sample on an edge belongs to one of its two sides by the renderers' fill rule, which moves all samples by the same
// infinitesimal step, so it is no exception. The depth of a pixel differs from the exact plane of its triangle by
// rounding only, which is bounded and compared with the distance to the far plane.
bool is_covered_once(const FramePlan& plan);

// Whether the outline of what is_covered_once() is convex on the screen, for the reason that a plan gives.
bool has_convex_outline(const FramePlan& plan);

}  // namespace morphcl
