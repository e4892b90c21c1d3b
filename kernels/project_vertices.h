// project_vertices: morph, transform and snap vertices, and make the attributes that shading needs.
//
// In:  mesh data (planes of x, y, z, ... padded to 16), the draws, their active targets, what precise ones need, the
//      numbers of the chunks that changed since the frame before.
// Out: vertices[i]   int4 {x, y in corner units, bits of depth (of forward depth buffers: the distance), bits of 1/w};
//                    {OUTSIDE, outcode, 0, 0} where clipping is due
//      attributes[i] float4: smooth draws: unit normal in eye space; flat draws: morphed position in object space; and
//                    where channel N needs one of them
//      colors[i]     float4: vertex colour after its deltas, clamped to [0, 1]
//      vertex_chunk_status[chunk] not 0 when a vertex of the chunk needs clipping
// Steps, 16 vertices at a time: 1 morph the position, 2 to clip space, 3 outcode, 4 snap, 5 attributes.
// One work-item walks a chunk of VERTEX_GROUPS_PER_CHUNK vertex groups. Where w is 1 everywhere nothing is divided,
// with the same result.

#ifndef MORPHCL_PROJECT_VERTICES_H
#define MORPHCL_PROJECT_VERTICES_H

#include "depth_format.h"
#include "layout.h"
#include "precise_vertices.h"
#include "tables.h"
#include "two_float.h"
#include "vector.h"
#include "vertex.h"

// Unit length; a normal that morphing cancelled (shorter than 2^-10) is replaced by the fallback.
static inline void normalize_or(float16* x, float16* y, float16* z, float16 fallback_x, float16 fallback_y,
                                float16 fallback_z) {
  const float16 square = fma(*x, *x, fma(*y, *y, *z * *z));
  const int16 usable = square >= MIN_NORMAL_SQUARE;
  *x = select(fallback_x, *x, usable);
  *y = select(fallback_y, *y, usable);
  *z = select(fallback_z, *z, usable);
}

static inline void store_normals(global const DrawConstants* draw, global const TargetConstants* targets,
                                 global const float* mesh_data, uint at, global int4* out) {
  float16 x, y, z;
  MORPH_3(mesh_data, draw->normals, draw->pitch, at, targets, draw->first_target, draw->target_count, normals, x, y, z)
  normalize_or(&x, &y, &z, vload16(0, mesh_data + draw->normals + at),
               vload16(0, mesh_data + draw->normals + draw->pitch + at),
               vload16(0, mesh_data + draw->normals + 2 * draw->pitch + at));
  const float16 eye_x = row_times_vector(draw->normal_to_eye[0], x, y, z);
  const float16 eye_y = row_times_vector(draw->normal_to_eye[1], x, y, z);
  const float16 eye_z = row_times_vector(draw->normal_to_eye[2], x, y, z);
  const float16 length = sqrt(fma(eye_x, eye_x, fma(eye_y, eye_y, eye_z * eye_z)));
  const int16 flat_out = ~(length > 0.0f);  // a singular transform: no direction is left, unlit
  const float16 divisor = select(length, (float16)1.0f, flat_out);
  store_records(as_int16(eye_x / divisor), as_int16(eye_y / divisor), as_int16(eye_z / divisor), (int16)0, out);
}

static inline float16 morphed_color_plane(global const DrawConstants* draw, global const TargetConstants* targets,
                                          global const float* mesh_data, uint at, uint plane) {
  const float16 base = vload16(0, mesh_data + draw->colors + plane * draw->pitch + at);
  float16 value = base;
  for (uint k = 0; k < draw->target_count; k++) {
    global const TargetConstants* target = &targets[draw->first_target + k];
    if (target->colors == NO_ID) continue;
    value = fma((float16)(target->weight), vload16(0, mesh_data + target->colors + plane * draw->pitch + at),
                fma((float16)(target->base_weight), base, value));
  }
  return min(max(value, (float16)0.0f), (float16)1.0f) + 0.0f;  // -0 becomes 0, with and without targets of weight 0
}

COMPILED_ONCE void project_chunk(uint item, global const FrameConstants* restrict frame,
                                 global const DrawConstants* restrict draws,
                                 global const TargetConstants* restrict targets, global const float* restrict mesh_data,
                                 global int4* restrict vertices, global int4* restrict attributes,
                                 global int4* restrict colors, global BinsHeader* restrict bins) {
  const uint chunk = changed_vertex_chunks(frame)[item];
  const uint end = min((chunk + 1) * VERTEX_GROUPS_PER_CHUNK, frame->vertex_group_count);
  int16 any_outside = 0;
  for (uint group = chunk * VERTEX_GROUPS_PER_CHUNK; group < end; group++) {
    global const DrawConstants* draw = &draws[draw_of_vertex_group(draws, frame)[group]];
    const uint at = (group - draw->first_vertex_group) * LANES;
    const size_t record = (size_t)group * LANES;

    float16 x, y, z;
    const ClipPoints clip = clip_points(draw, precise_constants(frame), targets, mesh_data, at, &x, &y, &z);
    const int16 code = outcode(clip, frame);
    const int16 outside = code != 0;
    any_outside |= outside;

    const float16 clip_x = select(clip.x, (float16)0.0f, outside), clip_y = select(clip.y, (float16)0.0f, outside);
    const float16 clip_z = select(clip.z, (float16)0.0f, outside);
    ScreenPoints screen;
    if (frame->divides) {
      const float16 w = select(clip.w, (float16)1.0f, outside);
      screen.x = snap(clip_x, w, frame->scale_x, frame->offset_x);
      screen.y = snap(clip_y, w, frame->scale_y, frame->offset_y);
      screen.inverse_w = 1.0f / w;
      screen.depth = vertex_depth(clip_z, w, screen.inverse_w, frame);
    } else {
      screen.x = snap_undivided(clip_x, frame->scale_x, frame->offset_x);
      screen.y = snap_undivided(clip_y, frame->scale_y, frame->offset_y);
      screen.inverse_w = 1.0f;
      screen.depth = vertex_depth(clip_z, (float16)1.0f, (float16)1.0f, frame);
    }
    store_records(select(screen.x, (int16)OUTSIDE, outside), select(screen.y, code, outside), as_int16(screen.depth),
                  as_int16(screen.inverse_w), vertices + record);

    if (draw->flags & (DRAW_SMOOTH | DRAW_VERTEX_NORMALS))
      store_normals(draw, targets, mesh_data, at, attributes + record);
    if (draw->flags & (DRAW_FLAT | DRAW_FACE_NORMALS))
      store_records(as_int16(x), as_int16(y), as_int16(z), (int16)0, attributes + record);
    if (draw->flags & DRAW_VERTEX_COLORS)
      store_records(as_int16(morphed_color_plane(draw, targets, mesh_data, at, 0)),
                    as_int16(morphed_color_plane(draw, targets, mesh_data, at, 1)),
                    as_int16(morphed_color_plane(draw, targets, mesh_data, at, 2)),
                    as_int16(morphed_color_plane(draw, targets, mesh_data, at, 3)), colors + record);
  }
  vertex_chunk_status(bins, frame)[chunk] = any_lane(any_outside);
}

#endif
