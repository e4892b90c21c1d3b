#pragma OPENCL FP_CONTRACT OFF
// The stages from vertices to bins. Starting a kernel takes as long as a thousand triangles, so stages of which each
// work-item needs no more than its own results share a launch:
//
// bin_primitives            the bins of one chunk of blocks
// light_and_bin_primitives  the same after the light of the chunk's faces
// project_light_and_bin     all of a frame that is no more than one chunk of vertices and one of blocks

#include "project_vertices.h"
#include "light_faces.h"
#include "bin_primitives.h"

kernel void bin_primitives(constant const FrameConstants* frame, global const DrawConstants* draws,
                           global const uint* block_draw, global const uint* position_draw, global const uint* indices,
                           global const int4* vertices, global const uint* clip_source, global const uint* clip_count,
                           global uint* fragment_heads, global uint* fragment_next, global ulong* fragment_keys,
                           global ushort* fragment_places, global uint* entry_heads, global uint* entry_next,
                           global uint* entry_triangles, global LargeTriangle* large, global ChunkStatus* status,
                           global uint* overflow) {
  bin_chunk((uint)get_global_id(0), frame, draws, block_draw, position_draw, indices, vertices, clip_source, clip_count,
            fragment_heads, fragment_next, fragment_keys, fragment_places, entry_heads, entry_next, entry_triangles,
            large, status, overflow);
}

kernel void light_and_bin_primitives(
    constant const FrameConstants* frame, global const DrawConstants* draws, global const uint* block_draw,
    global const uint* position_draw, global const uint* indices, global const int4* vertices,
    global const uint* clip_source, global const uint* clip_count, global uint* fragment_heads,
    global uint* fragment_next, global ulong* fragment_keys, global ushort* fragment_places, global uint* entry_heads,
    global uint* entry_next, global uint* entry_triangles, global LargeTriangle* large, global ChunkStatus* status,
    global uint* overflow, global const LightConstants* lights, global const int4* attributes,
    global int4* face_color) {
  const uint chunk = (uint)get_global_id(0);
  light_chunk(chunk, frame, draws, block_draw, indices, lights, attributes, face_color);
  bin_chunk(chunk, frame, draws, block_draw, position_draw, indices, vertices, clip_source, clip_count, fragment_heads,
            fragment_next, fragment_keys, fragment_places, entry_heads, entry_next, entry_triangles, large, status,
            overflow);
}

kernel void project_light_and_bin(
    constant const FrameConstants* frame, global const DrawConstants* draws, global const uint* block_draw,
    global const uint* position_draw, global const uint* indices, global int4* vertices,
    global const uint* clip_source, global const uint* clip_count, global uint* fragment_heads,
    global uint* fragment_next, global ulong* fragment_keys, global ushort* fragment_places, global uint* entry_heads,
    global uint* entry_next, global uint* entry_triangles, global LargeTriangle* large, global ChunkStatus* status,
    global uint* overflow, global const LightConstants* lights, global int4* attributes, global int4* face_color,
    global const uint* chunks, global const TargetConstants* targets, global const PreciseConstants* precise,
    global const uint* group_draw,
    global const float* mesh_data, global int4* colors, global uint* vertex_status) {
  project_chunk(0, frame, chunks, draws, targets, precise, group_draw, mesh_data, vertices, attributes, colors, vertex_status);
  light_chunk(0, frame, draws, block_draw, indices, lights, attributes, face_color);
  bin_chunk(0, frame, draws, block_draw, position_draw, indices, vertices, clip_source, clip_count, fragment_heads,
            fragment_next, fragment_keys, fragment_places, entry_heads, entry_next, entry_triangles, large, status,
            overflow);
}
