// What the parts of a frame cost, estimated from how much work they are.
#pragma once

#include <array>

#include "host/render/explain/workload.hpp"

namespace morphcl {

// Nanoseconds for each unit of work. Measured once: PoCL 3.1 on 2 cores of an AVX-512 server processor, two threads, as
// differences between frames that have more and less of the unit (docs/plan.md). Other machines differ by a factor that
// most units share: shares hold better than times.
struct CostModel {
  double frame = 200e3;  // launches and waits, whatever the frame holds
  double draw = 450;     // an object: evaluated, judged, written to the tables
  double vertex = 1.8;   // transformed, snapped and stored
  double divided_vertex = 0.2, clipped_vertex = 0.05;
  double pivot_vertex = 0.1, two_float_vertex = 2.1;  // of draws whose scene states an error: more than a plain one
  double target_vertex = 1.1;                         // an attribute of a target's vertex
  double smooth_vertex = 0.8, colored_vertex = 0.8;
  double mode = 230, modal_pair = 0.6;  // an elastic object's mode, and what it moves each mass
  double stepped_mass = 8e3;            // an elastic object's mass, 16 steps
  double triangle = 1.3;                // set up and binned
  double covered_share = 0.6;  // of the tiles that an object's box may touch: the pixels that it covers, in demos/
  double line = 14.0;          // the same, and drawn
  double face_light = 2.2;     // a triangle and a light
  double covered_pixel = 0.06, depth_test = 0.015;  // a pixel that something covers
  double forward_pixel = 2;                         // the same: what other depth buffers than the default take more
  double smooth_pixel = 0.34, pixel_light = 0.10;   // smooth shading: a pixel; a pixel and a light
  double span = 6.0, smooth_span = 9.0;             // a triangle in a row of pixels; the same, smoothly lit
  double tinted_pixel = 0.30;                       // vertex colours: a pixel
  double byte = 0.02;                               // of a pixel written
  double blended_pixel = 1.2;                       // a layer at a sample: sorted, shaded, blended
  double sample_span = 2.0, sample_triangle = 0.5;  // the same as span and triangle, for a sample of several
  // Channels beside colour and distance: tables of ids, a pixel or sample that something covers; a place in a
  // primitive, a covered pixel and a span; what is summed up there, a plane of a covered pixel and of a span; a sample
  // of an id's channel where a pixel may show several; a vertex of this frame and the next.
  double id_sample = 0.1, place_pixel = 0.6, place_span = 12.0, plane_pixel = 0.15, plane_span = 3.0;
  double share_sample = 1.5, next_vertex = 4.0;
};

// Milliseconds of this frame.
struct FrameCosts {
  double color, depth;  // written
  double draws, skipped;
  double targets, idle_targets;
  double elastic;
  double lights, normals, face_light, colors, lines;
  double clipping, divide, depth_test, depth_format, precise_vertices;
  double vertices;                             // everything that a frame with the same vertices need not do again
  double blending;                             // layers: sorted, shaded, blended
  double samples;                              // what several samples a pixel take more than one
  double centres;                              // beside them: to find what is at the pixels' centres
  std::array<double, channel_count> channels;  // each beside colour and distance
  double ids, next_vertices;                   // what they need beside
  double blank_pixels;                         // written where nothing is
  double everything;                           // the frame, with what is done in it
};

FrameCosts estimate_costs(const FramePlan& plan, const Workload& work, const SkippedWork& skipped,
                          const CostModel& model = {});

}  // namespace morphcl
