#pragma OPENCL FP_CONTRACT OFF
// clip_primitives: cuts triangles and lines that touch the near plane or the guard band, in homogeneous clip space.
//
// In:  vertices as projection left them (OUTSIDE marks the corners in question), indices, draws, targets, mesh data.
// Out: clipped[slot] one clipped primitive: the number of its source, how many corners it has (2 of a line, 3 to 8 of a
//      polygon), and for each corner the weights of the source triangle's three vertices; its corners as vertex records
//      at first_clip_vertex + 8 * slot. Slots are in order of the primitives' numbers, whatever the number of
//      work-items.
// Steps: count_clipped counts a chunk's primitives; clip_primitives starts where the earlier chunks end and, for each
//      primitive in order, 1 transforms its corners again, 2 cuts by the planes, 3 snaps
//      what is left.
// The cut of an edge is computed from its inner to its outer end and depends on nothing else, so the two triangles at a
// shared edge get the same bits; the plane's own coordinate is set, not computed.
// One work-item walks a chunk of primitive groups. What does not fit into the pool is counted but not stored.

#include "depth_format.h"
#include "layout.h"
#include "precise_vertices.h"
#include "tables.h"
#include "two_float.h"
#include "vector.h"
#include "vertex.h"

typedef struct {
  float x, y, z, w;
  float weight[3];
} Corner;

static inline uint corner_record(global const DrawConstants* draw, global const uint* indices, uint corner,
                                 uint primitive) {
  return draw->first_vertex_group * LANES + indices[draw->indices + corner * draw->index_pitch + primitive];
}

// Whether a primitive needs a slot: some corner is outside, but not all of them outside the same plane, none invalid.
static inline bool needs_clipping(global const int4* vertices, uint a, uint b, uint c) {
  const int4 va = vertices[a], vb = vertices[b], vc = vertices[c];
  const int code_a = va.x == OUTSIDE ? va.y : 0, code_b = vb.x == OUTSIDE ? vb.y : 0,
            code_c = vc.x == OUTSIDE ? vc.y : 0;
  const int all = code_a & code_b & code_c, some = code_a | code_b | code_c;
  return some != 0 && all == 0 && (some & OUT_INVALID) == 0;
}

COMPILED_ONCE void count_chunk(uint chunk, global const FrameConstants* restrict frame,
                               global const DrawConstants* restrict draws, global const uint* restrict indices,
                               global const int4* restrict vertices, global BinsHeader* restrict bins) {
  global const uint* vertex_status = vertex_chunk_status(bins, frame);
  const uint vertex_chunks = (frame->vertex_group_count + VERTEX_GROUPS_PER_CHUNK - 1) / VERTEX_GROUPS_PER_CHUNK;
  uint outside = 0, count = 0;
  for (uint i = 0; i < vertex_chunks; i++) outside |= vertex_status[i];
  if (outside) {
    const GroupRange groups = primitive_groups_of(chunk, frame);
    for (uint group = groups.first; group < groups.end; group++) {
      global const DrawConstants* draw = &draws[draw_of_primitive_group(draws, frame)[group]];
      for (uint lane = 0; lane < LANES; lane++) {
        const uint primitive = (group - draw->first_primitive_group) * LANES + lane;
        count += needs_clipping(vertices, corner_record(draw, indices, 0, primitive),
                                corner_record(draw, indices, 1, primitive), corner_record(draw, indices, 2, primitive));
      }
    }
  }
  chunk_status(bins, frame)[chunk].clipped = count;
}

kernel void count_clipped(global const FrameConstants* frame, global const DrawConstants* draws,
                          global const uint* indices, global const int4* vertices, global BinsHeader* bins) {
  count_chunk((uint)get_global_id(0), frame, draws, indices, vertices, bins);
}

// The source vertex in clip space. Sixteen lanes are loaded and one is kept: the arithmetic must be projection's own.
static inline Corner source_corner(global const DrawConstants* draw, global const PreciseConstants* precise,
                                   global const TargetConstants* targets, global const float* mesh_data, uint vertex,
                                   int number) {
  const uint at = vertex & ~(LANES - 1u), lane = vertex & (LANES - 1u);
  float16 x, y, z;
  const ClipPoints p = clip_points(draw, precise, targets, mesh_data, at, &x, &y, &z);
  float field[LANES];
  Corner corner;
  vstore16(p.x, 0, field);
  corner.x = field[lane];
  vstore16(p.y, 0, field);
  corner.y = field[lane];
  vstore16(p.z, 0, field);
  corner.z = field[lane];
  vstore16(p.w, 0, field);
  corner.w = field[lane];
  FOR_THREE(i) corner.weight[i] = i == number ? 1.0f : 0.0f;
  return corner;
}

// Positive inside.
static inline float plane_distance(const Corner* c, int plane, global const FrameConstants* frame) {
  if (plane == NEAR_PLANE) return near_distance((float16)(c->z), (float16)(c->w), frame).s0;
  if (plane == LEFT_PLANE) return fma(frame->guard_x, c->w, c->x);
  if (plane == RIGHT_PLANE) return fma(frame->guard_x, c->w, -c->x);
  if (plane == BOTTOM_PLANE) return fma(frame->guard_y, c->w, c->y);
  return fma(frame->guard_y, c->w, -c->y);
}

// (1 - t) a + t b, exact for t = 0, t = 1 and a = b, so that what lies on the near plane stays on it.
static inline float mix_exact_ends(float a, float b, float t) { return fma(t, b, fma(-t, a, a)); }

static inline Corner cut(const Corner* inner, const Corner* outer, float inner_distance, float outer_distance,
                         int plane, global const FrameConstants* frame) {
  const float t = inner_distance / (inner_distance - outer_distance);
  Corner c;
  c.x = mix_exact_ends(inner->x, outer->x, t);
  c.y = mix_exact_ends(inner->y, outer->y, t);
  c.z = mix_exact_ends(inner->z, outer->z, t);
  c.w = mix_exact_ends(inner->w, outer->w, t);
  FOR_THREE(i) c.weight[i] = mix_exact_ends(inner->weight[i], outer->weight[i], t);
  if (plane == NEAR_PLANE) {
    c.w = frame->camera.near_w;
    c.z = frame->camera.near_depth * c.w;
  } else if (plane == LEFT_PLANE) {
    c.x = -frame->guard_x * c.w;
  } else if (plane == RIGHT_PLANE) {
    c.x = frame->guard_x * c.w;
  } else if (plane == BOTTOM_PLANE) {
    c.y = -frame->guard_y * c.w;
  } else {
    c.y = frame->guard_y * c.w;
  }
  return c;
}

// Rounding can bend a sliver so that it crosses a plane more than twice; its excess corners are dropped, never written.
static inline void add_corner(Corner* out, int* count, Corner corner) {
  if (*count < CLIP_VERTICES) out[(*count)++] = corner;
}

// Cuts the closed polygon (or, with two corners, the open segment) by one plane; returns the number of corners left.
static inline int cut_by_plane(const Corner* in, int count, Corner* out, int plane,
                               global const FrameConstants* frame) {
  const int edges = count == 2 ? 1 : count;
  int left = 0;
  for (int i = 0; i < edges; i++) {
    const Corner *a = &in[i], *b = &in[i + 1 == count ? 0 : i + 1];
    const float da = plane_distance(a, plane, frame), db = plane_distance(b, plane, frame);
    if (da >= 0.0f) add_corner(out, &left, *a);
    if (da >= 0.0f && db < 0.0f) add_corner(out, &left, cut(a, b, da, db, plane, frame));
    if (da < 0.0f && db >= 0.0f) add_corner(out, &left, cut(b, a, db, da, plane, frame));
  }
  if (count == 2 && plane_distance(&in[1], plane, frame) >= 0.0f) add_corner(out, &left, in[1]);
  return left;
}

COMPILED_ONCE void clip_chunk(uint chunk, global const FrameConstants* restrict frame,
                              global const DrawConstants* restrict draws,
                              global const TargetConstants* restrict targets, global const float* restrict mesh_data,
                              global const uint* restrict indices, global int4* restrict vertices,
                              global ClippedPrimitive* restrict clipped, global BinsHeader* restrict bins) {
  global const ChunkStatus* status = chunk_status(bins, frame);
  if (status[chunk].clipped == 0) return;
  uint slot = 0;
  for (uint i = 0; i < chunk; i++) slot += status[i].clipped;
  const GroupRange groups = primitive_groups_of(chunk, frame);
  for (uint group = groups.first; group < groups.end; group++) {
    global const DrawConstants* draw = &draws[draw_of_primitive_group(draws, frame)[group]];
    for (uint lane = 0; lane < LANES; lane++) {
      const uint primitive = (group - draw->first_primitive_group) * LANES + lane;
      uint record[3];
      FOR_THREE(i) record[i] = corner_record(draw, indices, i, primitive);
      if (!needs_clipping(vertices, record[0], record[1], record[2])) continue;
      if (slot >= frame->clip_capacity) {
        slot++;
        continue;
      }
      Corner corners[CLIP_VERTICES], scratch[CLIP_VERTICES];
      int count = draw->flags & DRAW_LINES ? 2 : 3;
      for (int i = 0; i < count; i++)
        corners[i] = source_corner(draw, precise_constants(frame), targets, mesh_data,
                                   record[i] - draw->first_vertex_group * LANES, i);
      for (int plane = 0; plane < CLIP_PLANES && count > 0; plane++) {
        count = cut_by_plane(corners, count, scratch, plane, frame);
        for (int i = 0; i < count; i++) corners[i] = scratch[i];
      }
      global ClippedPrimitive* kept = &clipped[slot];
      kept->source = group * LANES + lane;
      kept->count = count;
      for (int i = 0; i < count; i++) {
        const Corner c = corners[i];
        const float inverse_w = 1.0f / c.w;
        const int x = snap((float16)(c.x), (float16)(c.w), frame->scale_x, frame->offset_x).s0;
        const int y = snap((float16)(c.y), (float16)(c.w), frame->scale_y, frame->offset_y).s0;
        const float depth = vertex_depth((float16)(c.z), (float16)(c.w), (float16)(inverse_w), frame).s0;
        vertices[frame->first_clip_vertex + slot * CLIP_VERTICES + i] = (int4)(x, y, as_int(depth), as_int(inverse_w));
        FOR_THREE(v) kept->weights[i][v] = c.weight[v];
      }
      slot++;
    }
  }
}

kernel void clip_primitives(global const FrameConstants* frame, global const DrawConstants* draws,
                            global const TargetConstants* targets, global const float* mesh_data,
                            global const uint* indices, global int4* vertices, global ClippedPrimitive* clipped,
                            global BinsHeader* bins) {
  clip_chunk((uint)get_global_id(0), frame, draws, targets, mesh_data, indices, vertices, clipped, bins);
}
