// How much work a planned frame is, counted.
#pragma once

#include "host/render/explain/screen_reach.hpp"
#include "host/render/frame/frame_plan.hpp"

namespace morphcl {

// Of the objects that are drawn, unless stated.
struct Workload {
  double draws = 0, vertices = 0;
  double triangles = 0, lines = 0;
  double target_vertices = 0;       // active target times vertex, once for each attribute it moves
  double idle_target_vertices = 0;  // the same of targets of weight 0
  double smooth_vertices = 0, colored_vertices = 0, flat_faces = 0;
  double pivot_vertices = 0, two_float_vertices = 0;  // of draws that are not plain
  double modes = 0, modal_pairs = 0;                  // of elastic objects in modes; with each mass
  double stepped_masses = 0;                          // of elastic objects in steps
  double lights = 0;
  // Of all triangles: those lit in every pixel, those with vertex colours, those that are blended.
  double smooth_share = 0, tinted_share = 0, blended_share = 0;
  double pixels = 0, reached_pixels = 0;  // of the picture; in tiles that an object may touch
  double bytes_per_pixel = 0;
};

Workload count_work(const FramePlan& plan, const ScreenReach& reach);

// Objects that are not drawn.
struct SkippedWork {
  double vertices = 0, triangles = 0;
};
SkippedWork count_skipped(const Scene& scene, const FramePlan& plan);

}  // namespace morphcl
