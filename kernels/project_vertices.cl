#pragma OPENCL FP_CONTRACT OFF
// One work-item projects one of the changed chunks of vertices.

#include "project_vertices.h"

kernel void project_vertices(constant const FrameConstants* frame, global const uint* chunks,
                             global const DrawConstants* draws, global const TargetConstants* targets,
                             global const PreciseConstants* precise, global const uint* group_draw, global const float* mesh_data, global int4* vertices,
                             global int4* attributes, global int4* colors, global uint* status) {
  project_chunk((uint)get_global_id(0), frame, chunks, draws, targets, precise, group_draw, mesh_data, vertices, attributes,
                colors, status);
}
