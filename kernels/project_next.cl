#pragma OPENCL FP_CONTRACT OFF
// project_next: where vertices are in this frame and in the next one, for velocity.
//
// In:  mesh data, the draws and their active targets; the same of the next frame.
// Out: motion[i] float4 {x, y, w of clip space, unused} of vertex i in this frame; motion[count + i] in the next one,
//      where count is that of all vertices, padded to groups.
// Steps, 16 vertices at a time: 1 morph the position and take it to clip space, 2 the same of the next frame. Draws
// that do not move are left out. One work-item walks a chunk of VERTEX_GROUPS_PER_CHUNK vertex groups.

#include "layout.h"
#include "precise_vertices.h"
#include "tables.h"
#include "two_float.h"
#include "vector.h"
#include "vertex.h"

static inline void store_clip_points(ClipPoints clip, global int4* out) {
  store_records(as_int16(clip.x), as_int16(clip.y), as_int16(clip.w), (int16)0, out);
}

COMPILED_ONCE void project_next_chunk(uint chunk, global const FrameConstants* restrict frame,
                                      global const DrawConstants* restrict draws,
                                      global const TargetConstants* restrict targets,
                                      global const float* restrict mesh_data, global int4* restrict motion) {
  const size_t count = (size_t)frame->vertex_group_count * LANES;
  const uint end = min((chunk + 1) * VERTEX_GROUPS_PER_CHUNK, frame->vertex_group_count);
  for (uint group = chunk * VERTEX_GROUPS_PER_CHUNK; group < end; group++) {
    const uint number = draw_of_vertex_group(draws, frame)[group];
    if (!channel_draws(frame)[number].moves) continue;
    const size_t record = (size_t)group * LANES;
    global const DrawConstants *now = &draws[number], *next = &next_draws(frame)[number];
    const uint at = (group - now->first_vertex_group) * LANES;
    float16 x, y, z;
    store_clip_points(clip_points(now, precise_constants(frame), targets, mesh_data, at, &x, &y, &z), motion + record);
    store_clip_points(clip_points(next, next_precise(frame), next_targets(frame), mesh_data, at, &x, &y, &z),
                      motion + count + record);
  }
}

kernel void project_next(global const FrameConstants* frame, global const DrawConstants* draws,
                         global const TargetConstants* targets, global const float* mesh_data, global int4* motion) {
  project_next_chunk((uint)get_global_id(0), frame, draws, targets, mesh_data, motion);
}
