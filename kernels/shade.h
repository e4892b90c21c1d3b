// The colour of 16 pixels of a row whose visible primitives are known: interpolation and light.
//
// Attributes are interpolated with perspective-correct weights: for corner i, the doubled area opposite to it at the
// pixel centre times 1 / w. A triangle that clipping cut has its weights at the cut corners turned into weights at the
// source triangle's vertices, so attributes are always those of the mesh.

#ifndef MORPHCL_SHADE_H
#define MORPHCL_SHADE_H

#include "depth_format.h"
#include "layout.h"
#include "light.h"
#include "raster.h"
#include "tables.h"
#include "vector.h"

// The buffer may be too coarse for lighting, and of several samples none is where a pixel is shaded.
#if defined(FORWARD_DEPTH) || SAMPLES > 1
#define INTERPOLATES_DISTANCE
#endif

typedef struct {
  global const FrameConstants* frame;
  global const DrawConstants* draws;
  global const uint* draw_of_group;
  global const uint* indices;
  global const int4 *vertices, *attributes, *colors, *face_colors;
  global const ClippedPrimitive* clipped;
  uint clipped_count;  // slots in use
} Shader;

#if SAMPLES == 1
typedef struct {
  int x, y;  // of the first pixel
  Depths depth;
} Pixels;
#else
// Places of any pixels of the picture, sub-pixels.
typedef struct {
  int16 x, y;                    // centres
  int16 centroid_x, centroid_y;  // from there: the mean of the samples that show the primitive
  bool centres_are_inside;       // of the primitives in all lanes: known without a look at them
} Pixels;
#endif

// What the colour of 16 pixels depends on beside their place: gathered once for all pixels that show one primitive.
typedef struct {
  global const DrawConstants* draw;
  Rgb color;         // base colour times the face's light
  int16 x[3], y[3];  // corners on the screen, corner units
  float16 inverse_w[3];
#ifdef INTERPOLATES_DISTANCE
  float16 depth[3];  // of the corners, as vertex records keep it
#endif
  EyeVector normal[3];  // at the mesh's vertices; smooth draws
  Rgb tint[3];          // vertex colours
#ifdef BLENDS
  float16 tint_alpha[3];
#endif
  bool any_cut;       // some lane's corners are those that clipping left;
  int16 is_cut;       // their weights at the mesh's vertices:
  float16 cut[3][3];  // [corner][vertex]
} Surface;

ALWAYS_INLINE Shader shader_of(global const FrameConstants* frame, global const DrawConstants* draws,
                               global const uint* indices, global const int4* vertices, global const int4* attributes,
                               global const int4* colors, global const int4* face_colors,
                               global const ClippedPrimitive* clipped, global BinsHeader* bins) {
  Shader s;
  s.frame = frame;
  s.draws = draws;
  s.draw_of_group = draw_of_primitive_group(draws, frame);
  s.indices = indices;
  s.vertices = vertices;
  s.attributes = attributes;
  s.colors = colors;
  s.face_colors = face_colors;
  s.clipped = clipped;
  s.clipped_count = 0;
  if (frame->clips)
    for (uint chunk = 0; chunk < frame->chunk_count; chunk++)
      s.clipped_count += chunk_status(bins, frame)[chunk].clipped;
  return s;
}

// Perspective-correct weights of the mesh's vertices, not divided by their sum; all have the sign of the triangle's
// orientation on the screen.
typedef struct {
  float16 vertex[3];
#ifdef INTERPOLATES_DISTANCE
  float16 distance;  // along the view axis, interpolated like an attribute
#endif
} Weights;

ALWAYS_INLINE float16 eye_distance(global const FrameConstants* frame, float16 depth) {
  return frame->camera.parallel ? -depth : frame->camera.near / depth;
}

// Draws whose pixels need the weights of the mesh's vertices, or a position.
#define NEEDS_WEIGHTS (DRAW_SMOOTH | DRAW_VERTEX_COLORS | DRAW_LIT_PER_PIXEL)

// ---- what is gathered -----------------------------------------------------------------------------------------------

// Record index[0] in all lanes, or record index[lane] in each.
ALWAYS_INLINE void fetch(global const int4* records, const uint* index, bool same, int16* f0, int16* f1, int16* f2,
                         int16* f3) {
  if (same) {
    const int4 record = records[index[0]];
    *f0 = record.x;
    *f1 = record.y;
    *f2 = record.z;
    *f3 = record.w;
    return;
  }
  GATHER_RECORDS(records, index, *f0, *f1, *f2, *f3)
}

// The slot of a clipped primitive; slots are sorted by the primitive's number.
ALWAYS_INLINE uint slot_of(const Shader* s, uint number) {
  uint low = 0, high = s->clipped_count;
  while (low + 1 < high) {
    const uint middle = (low + high) / 2;
    if (s->clipped[middle].source <= number)
      low = middle;
    else
      high = middle;
  }
  return low;
}

// Replaces the corners of primitives that were cut by those of the piece.
ALWAYS_INLINE void gather_cuts(const Shader* s, Lanes id, bool same, uint corner[3][LANES], Surface* surface) {
  surface->any_cut = false;
  float cut[3][3][LANES];
  int is_cut[LANES];
  for (int lane = 0; lane < (same ? 1 : LANES); lane++) {
    const uint piece = id.lane[lane] & (PIECES - 1u);
    is_cut[lane] = 0;
    if (piece == 0) continue;
    is_cut[lane] = -1;
    surface->any_cut = true;
    const uint slot = slot_of(s, id.lane[lane] >> PIECE_BITS), local_corner[3] = {0, piece, piece + 1};
    FOR_THREE(i) {
      global const float* weights = s->clipped[slot].weights[local_corner[i]];
      FOR_THREE(v) cut[i][v][lane] = weights[v];
      corner[i][lane] = s->frame->first_clip_vertex + slot * CLIP_VERTICES + local_corner[i];
    }
  }
  if (!surface->any_cut) return;
  surface->is_cut = same ? (int16)(is_cut[0]) : vload16(0, is_cut);
  FOR_THREE(i)
  FOR_THREE(v) surface->cut[i][v] = same ? (float16)(cut[i][v][0]) : vload16(0, cut[i][v]);
}

// The ids (the first alone when `same`) all belong to the draw.
ALWAYS_INLINE void gather_surface(const Shader* s, global const DrawConstants* draw, Lanes id, bool same,
                                  Surface* surface) {
  surface->draw = draw;
  surface->color.r = draw->base_color[0];
  surface->color.g = draw->base_color[1];
  surface->color.b = draw->base_color[2];
  int16 f0, f1, f2, unused;
  if (draw->flags & DRAW_FLAT) {
    const Lanes number = lanes_of(id.all >> PIECE_BITS);
    fetch(s->face_colors, number.lane, same, &f0, &f1, &f2, &unused);
    if (draw->flags & DRAW_LIT_PER_PIXEL) {
      surface->normal[0].x = as_float16(f0);
      surface->normal[0].y = as_float16(f1);
      surface->normal[0].z = as_float16(f2);
    } else {
      surface->color.r = as_float16(f0);
      surface->color.g = as_float16(f1);
      surface->color.b = as_float16(f2);
    }
  }
  if (!(draw->flags & NEEDS_WEIGHTS)) return;

  uint vertex[3][LANES], corner[3][LANES];
  const uint first_number = draw->first_primitive_group * LANES, first_vertex = draw->first_vertex_group * LANES;
  for (int lane = 0; lane < (same ? 1 : LANES); lane++) FOR_THREE(i)
  corner[i][lane] = vertex[i][lane] =
      first_vertex + s->indices[draw->indices + i * draw->index_pitch + ((id.lane[lane] >> PIECE_BITS) - first_number)];
  gather_cuts(s, id, same, corner, surface);
  FOR_THREE(i) {
    fetch(s->vertices, corner[i], same, &surface->x[i], &surface->y[i], &f1, &f0);
    surface->inverse_w[i] = as_float16(f0);
#ifdef INTERPOLATES_DISTANCE
    surface->depth[i] = as_float16(f1);
#endif
  }
  if (draw->flags & DRAW_SMOOTH) FOR_THREE(i) {
      fetch(s->attributes, vertex[i], same, &f0, &f1, &f2, &unused);
      surface->normal[i].x = as_float16(f0);
      surface->normal[i].y = as_float16(f1);
      surface->normal[i].z = as_float16(f2);
    }
  if (draw->flags & DRAW_VERTEX_COLORS) FOR_THREE(i) {
      fetch(s->colors, vertex[i], same, &f0, &f1, &f2, &unused);
      surface->tint[i].r = as_float16(f0);
      surface->tint[i].g = as_float16(f1);
      surface->tint[i].b = as_float16(f2);
#ifdef BLENDS
      surface->tint_alpha[i] = as_float16(unused);
#endif
    }
}

// ---- what is computed for each pixel --------------------------------------------------------------------------------

ALWAYS_INLINE float16 weighted(Weights w, float16 a, float16 b, float16 c) {
  return fma(w.vertex[0], a, fma(w.vertex[1], b, w.vertex[2] * c));
}

// Doubled areas opposite to the corners, square corner units, at places in sub-pixels.
typedef struct {
  float16 corner[3];
} Areas;
ALWAYS_INLINE Areas areas_at(const Surface* surface, int16 px, int16 py) {
  float16 dx[3], dy[3];
  FOR_THREE(i) {
    dx[i] = convert_float16(surface->x[i] - px * CORNER_UNITS);
    dy[i] = convert_float16(surface->y[i] - py * CORNER_UNITS);
  }
  Areas areas;
  areas.corner[0] = difference_of_products(dx[1], dy[2], dx[2], dy[1]);
  areas.corner[1] = difference_of_products(dx[2], dy[0], dx[0], dy[2]);
  areas.corner[2] = difference_of_products(dx[0], dy[1], dx[1], dy[0]);
  return areas;
}

// A place that coverage's grid has in the triangle may lie outside its corners: nothing is extrapolated there. Areas of
// the wrong sign become next to nothing, of no weight beside another one; that not all three are 0 keeps the mean
// defined.
#define MIN_AREA 0x1p-40f
ALWAYS_INLINE Areas within_triangle(global const DrawConstants* draw, Areas areas) {
  const float16 min_area = MIN_AREA;
  if (draw->flags & (DRAW_DOUBLE_SIDED | DRAW_LINES)) {
    const int16 negative = areas.corner[0] + areas.corner[1] + areas.corner[2] < 0.0f;
    FOR_THREE(i)
    areas.corner[i] = select(max(areas.corner[i], min_area), min(areas.corner[i], -min_area), negative);
  } else if (draw->flags & DRAW_MIRRORED) {
    FOR_THREE(i) areas.corner[i] = max(areas.corner[i], min_area);
  } else {
    FOR_THREE(i) areas.corner[i] = min(areas.corner[i], -min_area);
  }
  return areas;
}

#ifdef FORWARD_DEPTH
ALWAYS_INLINE float16 interpolated_distance(const Shader* s, const Surface* surface, Areas areas, Weights w) {
  return weighted(w, surface->depth[0], surface->depth[1], surface->depth[2]) /
         (w.vertex[0] + w.vertex[1] + w.vertex[2]);
}
#elif SAMPLES > 1
// The weights are areas over w: in perspective their sum over that of the areas is the mean of 1 / w.
ALWAYS_INLINE float16 interpolated_distance(const Shader* s, const Surface* surface, Areas areas, Weights w) {
  if (!s->frame->has_point_lights) return 0.0f;  // nobody asks
  const float16 total = w.vertex[0] + w.vertex[1] + w.vertex[2];
  if (s->frame->camera.parallel) return -(weighted(w, surface->depth[0], surface->depth[1], surface->depth[2]) / total);
  return (areas.corner[0] + areas.corner[1] + areas.corner[2]) / total;
}
#endif

ALWAYS_INLINE Weights weights_from(const Shader* s, const Surface* surface, Areas areas) {
  Weights w;
  FOR_THREE(i) w.vertex[i] = areas.corner[i];
  if (!s->frame->camera.parallel) FOR_THREE(i) w.vertex[i] *= surface->inverse_w[i];
#ifdef INTERPOLATES_DISTANCE
  w.distance = interpolated_distance(s, surface, areas, w);
#endif
  if (surface->any_cut) {
    const float16 a = weighted(w, surface->cut[0][0], surface->cut[1][0], surface->cut[2][0]);
    const float16 b = weighted(w, surface->cut[0][1], surface->cut[1][1], surface->cut[2][1]);
    const float16 c = weighted(w, surface->cut[0][2], surface->cut[1][2], surface->cut[2][2]);
    w.vertex[0] = select(w.vertex[0], a, surface->is_cut);
    w.vertex[1] = select(w.vertex[1], b, surface->is_cut);
    w.vertex[2] = select(w.vertex[2], c, surface->is_cut);
  }
  return w;
}

#if SAMPLES == 1
ALWAYS_INLINE Weights vertex_weights(const Shader* s, const Surface* surface, Pixels* p) {
  const int16 px = (p->x + LANE) * SUBPIXELS + HALF_PIXEL, py = p->y * SUBPIXELS + HALF_PIXEL;
  return weights_from(s, surface, within_triangle(surface->draw, areas_at(surface, px, py)));
}
#else
// At the centre where it is in the triangle, else at the centroid, to which the place moves.
ALWAYS_INLINE Weights vertex_weights(const Shader* s, const Surface* surface, Pixels* p) {
  Areas areas = areas_at(surface, p->x, p->y);
  if (p->centres_are_inside) return weights_from(s, surface, within_triangle(surface->draw, areas));
  const float16 low = min(areas.corner[0], min(areas.corner[1], areas.corner[2])),
                high = max(areas.corner[0], max(areas.corner[1], areas.corner[2]));
  const int16 outside = (low < 0.0f) & (high > 0.0f);
  if (any_lane(outside)) {
    p->x += p->centroid_x & outside;
    p->y += p->centroid_y & outside;
    areas = areas_at(surface, p->x, p->y);
  }
  return weights_from(s, surface, within_triangle(surface->draw, areas));
}
#endif

// Where what the pixels show is in eye space.
ALWAYS_INLINE EyeVector eye_position(const Shader* s, Pixels p, Weights w) {
#ifdef INTERPOLATES_DISTANCE
  const float16 distance = w.distance;
#else
  const float16 distance = eye_distance(s->frame, p.depth);
#endif
#if SAMPLES == 1
  const float16 x = convert_float16(p.x + LANE) + 0.5f, y = (float)p.y + 0.5f;
#else
  const float16 x = convert_float16(p.x) * (1.0f / SUBPIXELS), y = convert_float16(p.y) * (1.0f / SUBPIXELS);
#endif
  EyeVector position;
  position.x = fma(x, (float16)(s->frame->camera.ray[0]), (float16)(s->frame->camera.ray[1]));
  position.y = fma(y, (float16)(s->frame->camera.ray[2]), (float16)(s->frame->camera.ray[3]));
  if (s->frame->camera.parallel) {
    position.x = fma(distance, (float16)(s->frame->camera.slant[0]), position.x);
    position.y = fma(distance, (float16)(s->frame->camera.slant[1]), position.y);
  } else {
    position.x *= distance;
    position.y *= distance;
  }
  position.z = -distance;
  return position;
}

ALWAYS_INLINE Rgb smooth_light(const Shader* s, const Surface* surface, Pixels p, Weights w, float16 total) {
  EyeVector normal, position;
  normal.x = weighted(w, surface->normal[0].x, surface->normal[1].x, surface->normal[2].x);
  normal.y = weighted(w, surface->normal[0].y, surface->normal[1].y, surface->normal[2].y);
  normal.z = weighted(w, surface->normal[0].z, surface->normal[1].z, surface->normal[2].z);
  // The weights' sign goes, and on a double-sided draw the normal of a back face is turned round: both in one sign.
  const uint flags = surface->draw->flags;
  int16 negative = total < 0.0f;
  if (flags & DRAW_DOUBLE_SIDED) negative = flags & DRAW_MIRRORED ? (int16)(0) : (int16)(-1);
  normal.x = select(normal.x, -normal.x, negative);
  normal.y = select(normal.y, -normal.y, negative);
  normal.z = select(normal.z, -normal.z, negative);
  position.x = position.y = position.z = 0.0f;
  if (s->frame->has_point_lights) position = eye_position(s, p, w);
  return lambert(s->frame, normal, position);
}

ALWAYS_INLINE Rgb surface_color(const Shader* s, const Surface* surface, Pixels p) {
  Rgb color = surface->color;
  const uint flags = surface->draw->flags;
  if (!(flags & NEEDS_WEIGHTS)) return color;
  const Weights w = vertex_weights(s, surface, &p);
  const float16 total = w.vertex[0] + w.vertex[1] + w.vertex[2];
  if (flags & (DRAW_SMOOTH | DRAW_LIT_PER_PIXEL)) {
    const Rgb light = flags & DRAW_SMOOTH ? smooth_light(s, surface, p, w, total)
                                          : lambert(s->frame, surface->normal[0], eye_position(s, p, w));
    color.r *= light.r;
    color.g *= light.g;
    color.b *= light.b;
  }
  if (flags & DRAW_VERTEX_COLORS) {
    color.r *= weighted(w, surface->tint[0].r, surface->tint[1].r, surface->tint[2].r) / total;
    color.g *= weighted(w, surface->tint[0].g, surface->tint[1].g, surface->tint[2].g) / total;
    color.b *= weighted(w, surface->tint[0].b, surface->tint[1].b, surface->tint[2].b) / total;
  }
  return color;
}

ALWAYS_INLINE global const DrawConstants* draw_of(const Shader* s, uint id) {
  return &s->draws[s->draw_of_group[id / (PIECES * LANES)]];
}

// Where all colours are those of faces. The lanes of `of` have ids; the others are without meaning.
ALWAYS_INLINE Rgb colors_of_faces(const Shader* s, uint16 ids, int16 of) {
  const uint first = lanes_of(ids).lane[first_lane(of)];
  const uint16 all = select((uint16)(first), ids, as_uint16(of));
  int16 r, g, b, unused;
  if (any_lane(all != first)) {
    const Lanes number = lanes_of(all >> PIECE_BITS);
    GATHER_RECORDS(s->face_colors, number.lane, r, g, b, unused)
  } else {
    const int4 color = s->face_colors[first >> PIECE_BITS];
    r = color.x;
    g = color.y;
    b = color.z;
  }
  Rgb color;
  color.r = as_float16(r);
  color.g = as_float16(g);
  color.b = as_float16(b);
  return color;
}

// Pixels that show several primitives (NO_ID: none), gathered lane by lane, one draw after the other.
ALWAYS_INLINE Rgb mixed_color(const Shader* s, Pixels p, uint16 ids) {
  Rgb result;
  result.r = result.g = result.b = 0.0f;
  const Lanes id = lanes_of(ids);
  int16 waiting = ids != NO_ID;
  if (s->frame->only_faces) {
    const Rgb color = colors_of_faces(s, ids, waiting);
    result.r = select(result.r, color.r, waiting);
    result.g = select(result.g, color.g, waiting);
    result.b = select(result.b, color.b, waiting);
    return result;
  }
  while (any_lane(waiting)) {
    const uint first_id = id.lane[first_lane(waiting)];
    global const DrawConstants* draw = draw_of(s, first_id);
    const uint low = draw->first_primitive_group * (PIECES * LANES),
               high = low + (draw->primitive_group_count * (PIECES * LANES) - 1);
    const int16 here = waiting & (ids >= low) & (ids <= high);
    Surface surface;
    gather_surface(s, draw, lanes_of(select((uint16)(first_id), ids, as_uint16(here))), false, &surface);
    const Rgb color = surface_color(s, &surface, p);
    result.r = select(result.r, color.r, here);
    result.g = select(result.g, color.g, here);
    result.b = select(result.b, color.b, here);
    waiting &= ~here;
  }
  return result;
}

#endif
