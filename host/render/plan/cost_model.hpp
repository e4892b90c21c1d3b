// What the parts of a frame cost, estimated from how much work they are.
#pragma once

#include "host/render/plan/workload.hpp"

namespace morphcl {

// Nanoseconds for each unit of work. Measured once: PoCL 3.1 on 2 cores of an AVX-512 server processor, two threads,
// pictures of 1920 x 1080, with bench/plan_savings.cpp and bench/draw.cpp (docs/plan.md has the measurements). Other
// machines differ by a factor, which is the same for most units: shares hold better than times.
struct CostModel {
  double frame = 150e3;  // launches and waits, whatever the frame holds
  double draw = 400;     // an object: evaluated, judged, written to the tables
  double vertex = 3.0;   // transformed, snapped and stored
  double target_vertex = 1.5, smooth_vertex = 2.0, colored_vertex = 2.0;
  double divided_vertex = 0.5, clipped_vertex = 0.3;
  double triangle = 6.0;  // set up and binned
  double line = 20.0;
  double face_light = 8.0;                        // a triangle and a light
  double covered_pixel = 0.15;                    // visibility and shading of a pixel that something may cover
  double depth_test = 0.05;                       // a pixel
  double pixel_light = 0.35, tinted_pixel = 0.3;  // smooth shading: a pixel and a light; vertex colours: a pixel
  double byte = 0.04;                             // of a pixel written
};

// Milliseconds of this frame.
struct FrameCosts {
  double color, depth;  // written
  double draws, skipped;
  double targets, idle_targets;
  double lights, normals, face_light, colors, lines;
  double clipping, divide, depth_test;
  double vertices;      // everything that a frame with the same vertices need not do again
  double blank_pixels;  // written where nothing is
  double everything;    // the frame, with what is done in it
};

FrameCosts estimate_costs(const FramePlan& plan, const Workload& work, const SkippedWork& skipped,
                          const CostModel& model = {});

}  // namespace morphcl
