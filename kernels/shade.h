// The colour of 16 pixels of a row whose visible primitives are known: interpolation and light.
//
// Attributes are interpolated with perspective-correct weights: for corner i, the doubled area opposite to it at the pixel
// centre times 1 / w. A triangle that clipping cut has its weights at the cut corners turned into weights at the source
// triangle's vertices, so attributes are always those of the mesh.

#ifndef MORPHCL_SHADE_H
#define MORPHCL_SHADE_H

typedef struct {
  constant const FrameConstants* frame;
  global const DrawConstants* draws;
  global const BlockConstants* blocks;
  global const uint* indices;
  global const LightConstants* lights;
  global const int4 *vertices, *attributes, *colors, *face_light;
  global const uint* clip_source;
  global const float4* clip_weights;
  uint clipped;  // slots in use
} Shader;

typedef struct {
  int x, y;  // of the first pixel
  float16 depth;
  uint16 id;  // NO_ID where nothing is visible
  uint first_id;
  bool same;  // all ids are equal
} Pixels;

// Perspective-correct weights of the source triangle's vertices, not divided by their sum; all have the sign of the
// triangle's orientation on the screen.
typedef struct {
  float16 vertex[3];
} Weights;

ALWAYS_INLINE float16 eye_distance(constant const FrameConstants* frame, float16 depth) {
  return frame->parallel ? -depth : frame->near / depth;
}

ALWAYS_INLINE void fetch(global const int4* records, const uint* index, bool same, int16* f0, int16* f1, int16* f2, int16* f3) {
  if (same) {
    const int4 record = records[index[0]];
    *f0 = record.x, *f1 = record.y, *f2 = record.z, *f3 = record.w;
    return;
  }
  GATHER_RECORDS(records, index, *f0, *f1, *f2, *f3)
}

// The slot of a clipped primitive; slots are sorted by the primitive's number.
ALWAYS_INLINE uint slot_of(const Shader* s, uint number) {
  uint low = 0, high = s->clipped;
  while (low + 1 < high) {
    const uint middle = (low + high) / 2;
    if (s->clip_source[middle] <= number)
      low = middle;
    else
      high = middle;
  }
  return low;
}

ALWAYS_INLINE Weights screen_weights(const Shader* s, Pixels p, uint corner[3][LANES]) {
  int16 x[3], y[3], unused, inverse_w[3];
  for (int i = 0; i < 3; i++) fetch(s->vertices, corner[i], p.same, &x[i], &y[i], &unused, &inverse_w[i]);
  const int16 px = (p.x + LANE) * SUBPIXELS + HALF_PIXEL, py = p.y * SUBPIXELS + HALF_PIXEL;
  float16 dx[3], dy[3];
  for (int i = 0; i < 3; i++) dx[i] = convert_float16(x[i] - px), dy[i] = convert_float16(y[i] - py);
  Weights w;
  w.vertex[0] = difference_of_products(dx[1], dy[2], dx[2], dy[1]);
  w.vertex[1] = difference_of_products(dx[2], dy[0], dx[0], dy[2]);
  w.vertex[2] = difference_of_products(dx[0], dy[1], dx[1], dy[0]);
  if (!s->frame->parallel)
    for (int i = 0; i < 3; i++) w.vertex[i] *= as_float16(inverse_w[i]);
  return w;
}

// Weights at cut corners become weights at the source triangle's vertices; slot is NO_ID in lanes that were not cut.
ALWAYS_INLINE Weights source_weights(const Shader* s, Weights cut, const uint* slot, const uint* piece) {
  float in[3][LANES], out[3][LANES];
  for (int i = 0; i < 3; i++) vstore16(cut.vertex[i], 0, in[i]), vstore16(cut.vertex[i], 0, out[i]);
  for (int lane = 0; lane < LANES; lane++) {
    if (slot[lane] == NO_ID) continue;
    global const float4* weights = s->clip_weights + slot[lane] * CLIP_VERTICES;
    const float4 a = weights[0], b = weights[piece[lane]], c = weights[piece[lane] + 1];
    out[0][lane] = fma(in[0][lane], a.x, fma(in[1][lane], b.x, in[2][lane] * c.x));
    out[1][lane] = fma(in[0][lane], a.y, fma(in[1][lane], b.y, in[2][lane] * c.y));
    out[2][lane] = fma(in[0][lane], a.z, fma(in[1][lane], b.z, in[2][lane] * c.z));
  }
  Weights w;
  for (int i = 0; i < 3; i++) w.vertex[i] = vload16(0, out[i]);
  return w;
}

ALWAYS_INLINE Weights vertex_weights(const Shader* s, Pixels p, const uint* id, uint vertex[3][LANES]) {
  uint corner[3][LANES], slot[LANES], piece[LANES];
  bool any_cut = false;
  const int lanes = p.same ? 1 : LANES;
  for (int lane = 0; lane < lanes; lane++) {
    piece[lane] = id[lane] & 7u, slot[lane] = NO_ID;
    for (int i = 0; i < 3; i++) corner[i][lane] = vertex[i][lane];
    if (piece[lane] == 0) continue;
    any_cut = true;
    slot[lane] = slot_of(s, id[lane] >> 3);
    const uint first = s->frame->first_clip_vertex + slot[lane] * CLIP_VERTICES;
    corner[0][lane] = first, corner[1][lane] = first + piece[lane], corner[2][lane] = first + piece[lane] + 1;
  }
  const Weights w = screen_weights(s, p, corner);
  if (!any_cut) return w;
  for (int lane = lanes; lane < LANES; lane++) slot[lane] = slot[0], piece[lane] = piece[0];
  return source_weights(s, w, slot, piece);
}

ALWAYS_INLINE Irradiance interpolate(global const int4* records, uint vertex[3][LANES], bool same, Weights w) {
  int16 x[3], y[3], z[3], unused;
  for (int i = 0; i < 3; i++) fetch(records, vertex[i], same, &x[i], &y[i], &z[i], &unused);
  Irradiance sum;
  sum.r = fma(w.vertex[0], as_float16(x[0]), fma(w.vertex[1], as_float16(x[1]), w.vertex[2] * as_float16(x[2])));
  sum.g = fma(w.vertex[0], as_float16(y[0]), fma(w.vertex[1], as_float16(y[1]), w.vertex[2] * as_float16(y[2])));
  sum.b = fma(w.vertex[0], as_float16(z[0]), fma(w.vertex[1], as_float16(z[1]), w.vertex[2] * as_float16(z[2])));
  return sum;
}

ALWAYS_INLINE Irradiance smooth_light(const Shader* s, global const DrawConstants* draw, Pixels p, uint vertex[3][LANES], Weights w) {
  const Irradiance n = interpolate(s->attributes, vertex, p.same, w);
  const float16 total = w.vertex[0] + w.vertex[1] + w.vertex[2];
  // The weights' sign goes, and on a double-sided draw the normal of a back face is turned round: both in one sign.
  int16 negative = total < 0.0f;
  if (draw->flags & DRAW_DOUBLE_SIDED) negative = draw->flags & DRAW_MIRRORED ? (int16)(0) : (int16)(-1);
  EyeVector normal, position;
  normal.x = select(n.r, -n.r, negative), normal.y = select(n.g, -n.g, negative), normal.z = select(n.b, -n.b, negative);
  position.x = position.y = position.z = 0.0f;
  if (!s->frame->has_point_lights) return irradiance(s->frame, s->lights, normal, position);
  const float16 reach = s->frame->parallel ? (float16)1.0f : eye_distance(s->frame, p.depth);
  const float16 x = convert_float16(p.x + LANE) + 0.5f, y = (float)p.y + 0.5f;
  position.x = fma(x, (float16)(s->frame->ray[0]), (float16)(s->frame->ray[1])) * reach;
  position.y = fma(y, (float16)(s->frame->ray[2]), (float16)(s->frame->ray[3])) * reach;
  position.z = -eye_distance(s->frame, p.depth);
  return irradiance(s->frame, s->lights, normal, position);
}

// The lanes' ids all belong to one draw.
ALWAYS_INLINE Irradiance shade_draw(const Shader* s, global const DrawConstants* draw, Pixels p, const uint* id) {
  Irradiance color;
  color.r = draw->base_color[0], color.g = draw->base_color[1], color.b = draw->base_color[2];
  if (draw->flags & DRAW_FLAT) {
    uint number[LANES];
    for (int lane = 0; lane < (p.same ? 1 : LANES); lane++) number[lane] = id[lane] >> 3;
    int16 r, g, b, unused;
    fetch(s->face_light, number, p.same, &r, &g, &b, &unused);
    color.r *= as_float16(r), color.g *= as_float16(g), color.b *= as_float16(b);
  }
  if (!(draw->flags & (DRAW_SMOOTH | DRAW_VERTEX_COLORS))) return color;

  uint vertex[3][LANES];
  for (int lane = 0; lane < (p.same ? 1 : LANES); lane++) {
    const uint number = id[lane] >> 3, primitive = s->blocks[number / LANES].first + number % LANES;
    for (int i = 0; i < 3; i++)
      vertex[i][lane] = draw->first_group * LANES + s->indices[draw->indices + i * draw->index_pitch + primitive];
  }
  const Weights w = vertex_weights(s, p, id, vertex);
  if (draw->flags & DRAW_SMOOTH) {
    const Irradiance light = smooth_light(s, draw, p, vertex, w);
    color.r *= light.r, color.g *= light.g, color.b *= light.b;
  }
  if (draw->flags & DRAW_VERTEX_COLORS) {
    const Irradiance tint = interpolate(s->colors, vertex, p.same, w);
    const float16 total = w.vertex[0] + w.vertex[1] + w.vertex[2];
    color.r *= tint.r / total, color.g *= tint.g / total, color.b *= tint.b / total;
  }
  return color;
}

ALWAYS_INLINE Irradiance shade(const Shader* s, Pixels p) {
  uint id[LANES];
  if (p.same) {
    id[0] = p.first_id;
    return shade_draw(s, &s->draws[s->blocks[p.first_id / (8 * LANES)].draw], p, id);
  }
  Irradiance result;
  result.r = result.g = result.b = 0.0f;
  int16 waiting = p.id != NO_ID;
  while (any_lane(waiting)) {
    // The draw of the first waiting lane, and all lanes whose ids belong to it; the others repeat that lane's id.
    const ulong2 bytes = mask_bytes(waiting);
    vstore16(p.id, 0, id);
    const uint first_id = id[bytes.x ? lowest_lane(bytes.x) : 8 + lowest_lane(bytes.y)];
    global const DrawConstants* draw = &s->draws[s->blocks[first_id / (8 * LANES)].draw];
    const uint low = draw->first_block * (8 * LANES), high = low + (draw->block_count * (8 * LANES) - 1);
    const int16 here = waiting & (p.id >= low) & (p.id <= high);
    vstore16(select((uint16)(first_id), p.id, as_uint16(here)), 0, id);
    const Irradiance color = shade_draw(s, draw, p, id);
    result.r = select(result.r, color.r, here);
    result.g = select(result.g, color.g, here);
    result.b = select(result.b, color.b, here);
    waiting &= ~here;
  }
  return result;
}

#endif
