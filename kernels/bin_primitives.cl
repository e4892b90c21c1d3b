#pragma OPENCL FP_CONTRACT OFF
// The stages from vertices to bins. Starting a kernel takes as long as a thousand triangles, so stages of which each
// work-item needs no more than its own results share a launch:
//
// bin_primitives            the bins of one chunk of primitive groups
// light_and_bin_primitives  the same after the light of the chunk's faces
// project_light_and_bin     all of a frame that is no more than one chunk of vertices and one of primitives, of which
//                           nothing is clipped
//
// In, out and steps are those of the stages: project_vertices.h, light_faces.h, bin_primitives.h.

#include "bin_primitives.h"
#include "light_faces.h"
#include "project_vertices.h"

kernel void bin_primitives(global const FrameConstants* frame, global const DrawConstants* draws,
                           global const uint* indices, global const int4* vertices,
                           global const ClippedPrimitive* clipped, global ulong* fragment_keys, global BinsHeader* bins,
                           global LargeTriangle* large) {
  bin_chunk((uint)get_global_id(0), frame, draws, indices, vertices, clipped, fragment_keys, bins, large);
}

kernel void light_and_bin_primitives(global const FrameConstants* frame, global const DrawConstants* draws,
                                     global const uint* indices, global const int4* vertices,
                                     global const int4* attributes, global int4* face_colors,
                                     global const ClippedPrimitive* clipped, global ulong* fragment_keys,
                                     global BinsHeader* bins, global LargeTriangle* large) {
  light_chunk((uint)get_global_id(0), frame, draws, indices, attributes, face_colors);
  bin_chunk((uint)get_global_id(0), frame, draws, indices, vertices, clipped, fragment_keys, bins, large);
}

kernel void project_light_and_bin(global const FrameConstants* frame, global const DrawConstants* draws,
                                  global const TargetConstants* targets, global const float* mesh_data,
                                  global const uint* indices, global int4* vertices, global int4* attributes,
                                  global int4* colors, global int4* face_colors, global ulong* fragment_keys,
                                  global BinsHeader* bins, global LargeTriangle* large) {
  project_chunk(0, frame, draws, targets, mesh_data, vertices, attributes, colors, bins);
  light_chunk(0, frame, draws, indices, attributes, face_colors);
  bin_chunk(0, frame, draws, indices, vertices, 0, fragment_keys, bins, large);
}
