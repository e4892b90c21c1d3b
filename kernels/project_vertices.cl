#pragma OPENCL FP_CONTRACT OFF
// project_vertices: one work-item projects one of the changed chunks of vertices. In, out and steps:
// project_vertices.h.

#include "project_vertices.h"

kernel void project_vertices(global const FrameConstants* frame, global const DrawConstants* draws,
                             global const TargetConstants* targets, global const float* mesh_data,
                             global int4* vertices, global int4* attributes, global int4* colors,
                             global BinsHeader* bins) {
  project_chunk((uint)get_global_id(0), frame, draws, targets, mesh_data, vertices, attributes, colors, bins);
}
