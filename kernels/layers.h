// Blended surfaces: what lies in front of a tile's opaque surfaces, sample by sample, from front to back.
//
// Bins keep blended fragments and large triangles in lists of their own. A row of blocks at a time, layers are sorted
// into planes: plane 0 holds the nearest of each sample, of equal depths the one drawn last. They are blended from the
// front: with T the transmittance, 1 at first,
//   colour <- fma(T alpha, surface, colour),  T <- fma(-T, alpha, T)
// and what is opaque behind, or the background, comes last with what is left of T. Where a sample has more layers than
// there are planes, the next pass sorts those behind the last one; so memory is bounded, and nothing is dropped.

#ifndef MORPHCL_LAYERS_H
#define MORPHCL_LAYERS_H

#include "depth_format.h"
#include "layer_planes.h"
#include "layout.h"
#include "light.h"
#include "raster.h"
#include "shade.h"
#include "tables.h"
#include "tile.h"
#include "tile_ids.h"
#include "vector.h"

// What layers leave of 16 pixels of a row: premultiplied colours, transmittance, and the nearest surface whose alpha is
// at least one half (NO_ID: none), of one sample with its depth.
typedef struct {
  float16 red[SAMPLES], green[SAMPLES], blue[SAMPLES], transmittance[SAMPLES];
  uint16 id[SAMPLES];
#if SAMPLES == 1
  Depths depth;
#endif
} LayeredRow;

// A tile's layers while it is drawn.
typedef struct {
  LayerPlanes* planes;
  LayeredRow* rows;  // of a row of blocks: STRIP_ROWS
  uint blocks;       // a bit a block of the tile: some layer may be there
} Layers;

// ---- surfaces -------------------------------------------------------------------------------------------------------

// Colours, not multiplied by alpha.
typedef struct {
  Rgb color;
  float16 alpha;
} BlendedSurface;

ALWAYS_INLINE float16 surface_alpha(const Shader* s, const Surface* surface, Pixels p) {
  float16 alpha = surface->draw->base_color[3];
  if (surface->draw->flags & DRAW_VERTEX_COLORS) {
    const Weights w = vertex_weights(s, surface, &p);
    const float16 total = w.vertex[0] + w.vertex[1] + w.vertex[2];
    alpha *= weighted(w, surface->tint_alpha[0], surface->tint_alpha[1], surface->tint_alpha[2]) / total;
  }
  alpha = min(max(alpha, (float16)(0.0f)), (float16)(1.0f));
  const float cutoff = surface->draw->alpha_cutoff;
  if (cutoff < 0.0f) return alpha;
  return select((float16)(0.0f), (float16)(1.0f), alpha >= cutoff);
}

#if SAMPLES > 1
// Centroids for pixels whose centre is not in the triangle: the mean of all samples that it covers.
static inline void set_centroids_of_coverage(const Surface* surface, Pixels* p) {
  const Areas areas = areas_at(surface, p->x, p->y);
  const float16 low = min(areas.corner[0], min(areas.corner[1], areas.corner[2])),
                high = max(areas.corner[0], max(areas.corner[1], areas.corner[2]));
  if (!any_lane((low < 0.0f) & (high > 0.0f))) return;
  int16 vx[3], vy[3];
  FOR_THREE(i) {
    vx[i] = SUBPIXEL_OF(surface->x[i]);
    vy[i] = SUBPIXEL_OF(surface->y[i]);
  }
  const long16 area = convert_long16(vx[1] - vx[0]) * convert_long16(vy[2] - vy[0]) -
                      convert_long16(vx[2] - vx[0]) * convert_long16(vy[1] - vy[0]);
  const int16 positive = convert_int16(area > 0);
  int16 sum_x = 0, sum_y = 0, count = 0;
  for (int i = 0; i < SAMPLES; i++) {
    const int16 x = p->x + sample_x[i] * SAMPLE_UNIT, y = p->y + sample_y[i] * SAMPLE_UNIT;
    int16 covered = -1;
    FOR_THREE(e) {
      const int next = (e + 1) % 3;
      const int16 dx = select(vx[e] - vx[next], vx[next] - vx[e], positive),
                  dy = select(vy[e] - vy[next], vy[next] - vy[e], positive);
      const int16 owns_edge = (dy < 0) | ((dy == 0) & (dx > 0));
      const long16 value =
          convert_long16(dx) * convert_long16(y - vy[e]) - convert_long16(dy) * convert_long16(x - vx[e]);
      covered &= select(convert_int16(value > 0), convert_int16(value >= 0), owns_edge);
    }
    sum_x += covered & sample_x[i];
    sum_y += covered & sample_y[i];
    count -= covered;
  }
  const float16 samples = convert_float16(max(count, (int16)(1)));
  p->centroid_x = mean_offset(sum_x, samples);
  p->centroid_y = mean_offset(sum_y, samples);
  p->centres_are_inside = false;
}
#endif

ALWAYS_INLINE BlendedSurface blended_surface(const Shader* s, const Surface* surface, Pixels p) {
#if SAMPLES > 1
  if (surface->draw->flags & NEEDS_WEIGHTS) set_centroids_of_coverage(surface, &p);
#endif
  BlendedSurface result;
  result.alpha = surface_alpha(s, surface, p);
  result.color.r = result.color.g = result.color.b = 0.0f;
  if (s->frame->writes_color) result.color = surface_color(s, surface, p);
  return result;
}

// A surface that is kept while its id stays.
typedef struct {
  uint id;  // NO_ID: none
  Surface surface;
} KeptSurface;

// Of the lanes that are `waiting`; the others are without meaning.
COMPILED_ONCE BlendedSurface blended_surfaces(const Shader* s, const Pixels* p, uint16 ids, int16 waiting,
                                              KeptSurface* kept) {
  const Lanes id = lanes_of(ids);
  uint first_id = id.lane[first_lane(waiting)];
  if (!any_lane(waiting & (ids != first_id))) {
    if (kept->id != first_id) gather_surface(s, draw_of(s, first_id), lanes_of(first_id), true, &kept->surface);
    kept->id = first_id;
    return blended_surface(s, &kept->surface, *p);
  }
  BlendedSurface result;
  result.color.r = result.color.g = result.color.b = result.alpha = 0.0f;
  for (;;) {
    global const DrawConstants* draw = draw_of(s, first_id);
    const uint low = draw->first_primitive_group * (PIECES * LANES),
               high = low + (draw->primitive_group_count * (PIECES * LANES) - 1);
    const int16 here = waiting & (ids >= low) & (ids <= high);
    Surface surface;
    gather_surface(s, draw, lanes_of(select((uint16)(first_id), ids, as_uint16(here))), false, &surface);
    const BlendedSurface of_draw = blended_surface(s, &surface, *p);
    result.alpha = select(result.alpha, of_draw.alpha, here);
    result.color.r = select(result.color.r, of_draw.color.r, here);
    result.color.g = select(result.color.g, of_draw.color.g, here);
    result.color.b = select(result.color.b, of_draw.color.b, here);
    waiting &= ~here;
    if (!any_lane(waiting)) return result;
    first_id = id.lane[first_lane(waiting)];
  }
}

// Where it is what distances, ids and the like are of, if nothing before it is.
ALWAYS_INLINE int16 shows(BlendedSurface surface) { return surface.alpha >= 0.5f; }

ALWAYS_INLINE void blend_over(LayeredRow* row, int sample, BlendedSurface surface, uint16 ids, int16 lanes) {
  const float16 through = row->transmittance[sample], alpha = select((float16)(0.0f), surface.alpha, lanes),
                share = through * alpha;
  row->red[sample] = select(row->red[sample], fma(share, surface.color.r, row->red[sample]), lanes);
  row->green[sample] = select(row->green[sample], fma(share, surface.color.g, row->green[sample]), lanes);
  row->blue[sample] = select(row->blue[sample], fma(share, surface.color.b, row->blue[sample]), lanes);
  row->transmittance[sample] = fma(-through, alpha, through);
  row->id[sample] = select(row->id[sample], ids, as_uint16(lanes & shows(surface) & (row->id[sample] == NO_ID)));
}

// Blends what plane `place`, counted from the front, holds of 16 pixels of a row, the first of which is (x, y); `at`:
// the row in the row of blocks.
#if SAMPLES == 1
ALWAYS_INLINE void blend_row(const Shader* s, const LayerPlanes* planes, uint place, int at, int x, int y,
                             LayeredRow* row, KeptSurface* kept) {
  if (place >= planes->count[at]) return;
  const uint i = planes->order[at][place] * STRIP_VECTORS + at;
  const uint16 ids = planes->rank[i] - 1u;
  const int16 lanes = ids != NO_ID;
  Pixels p;
  p.x = x;
  p.y = y;
  p.depth = planes->depth[i];
  const BlendedSurface surface = blended_surfaces(s, &p, ids, lanes, kept);
  row->depth = select(row->depth, p.depth, lanes & shows(surface) & (row->id[0] == NO_ID));
  blend_over(row, 0, surface, ids, lanes);
}
#else
ALWAYS_INLINE void blend_row(const Shader* s, const LayerPlanes* planes, uint place, int at, int x, int y,
                             LayeredRow* row, KeptSurface* kept) {
  uint16 ids[SAMPLES];
  uint count = 0;
  for (int k = 0; k < SAMPLES; k++) {
    const int vector = at * SAMPLES + k;
    const uint planes_here = planes->count[vector];
    count = max(count, planes_here);
    ids[k] = place < planes_here ? planes->rank[planes->order[vector][place] * STRIP_VECTORS + vector] - 1u
                                 : (uint16)(NO_ID);
  }
  if (place >= count) return;
  Pixels p;
  p.x = (x + LANE) * SUBPIXELS + HALF_PIXEL;
  p.y = y * SUBPIXELS + HALF_PIXEL;
  p.centroid_x = p.centroid_y = 0;
  p.centres_are_inside = true;  // unless set_centroids_of_coverage() finds out
  split_samples(ids);
  for (int i = 0; i < SAMPLES; i++) {
    int16 first = ids[i] != NO_ID;
    for (int before = 0; before < i; before++) first &= ids[before] != ids[i];
    if (!any_lane(first)) continue;
    const BlendedSurface surface = blended_surfaces(s, &p, ids[i], first, kept);
    for (int other = i; other < SAMPLES; other++)
      blend_over(row, other, surface, ids[i], first & (ids[other] == ids[i]));
  }
}
#endif

// Blends all planes of a block, of which `rows` rows are in the picture, behind those of earlier passes.
static inline void blend_block(const Shader* s, const LayerPlanes* planes, int column, int rows, int x, int y,
                               LayeredRow* layered) {
  const int first = column * TILE_BLOCK;
  uint count = 0;
  for (int i = first * SAMPLES; i < (first + rows) * SAMPLES; i++) count = max(count, (uint)planes->count[i]);
  KeptSurface kept;
  kept.id = NO_ID;
  for (uint place = 0; place < count; place++)
    for (int row = 0; row < rows; row++)
      blend_row(s, planes, place, first + row, x, y + row, &layered[first + row], &kept);
}

// ---- tiles ----------------------------------------------------------------------------------------------------------

// Finds the blocks with layers and writes out what is opaque in them, sample by sample.
static inline void find_layers(Layers* layers, const BlendedLists* lists, Tile tile, Blocks* blocks,
                               global const LargeTriangle* large) {
  layers->blocks = blocks_with_layers(lists, tile, blocks);
  const Lanes content = lanes_of(blocks->content);
  for (int block = 0; block < LANES; block++) {
    if (!(layers->blocks >> block & 1u) || content.lane[block] == PER_PIXEL) continue;
    write_out_block(tile, block, content.lane[block], large, background_depth(lists->frame));
    blocks->content = select(blocks->content, (uint16)(PER_PIXEL), as_uint16(LANE == block));
  }
}

// All layers of a row of blocks, of which `rows` rows are in the picture.
static inline void blend_strip(Layers* layers, const Shader* s, const BlendedLists* lists, Tile tile,
                               const Blocks* blocks, int strip, int rows) {
  const uint here = layers->blocks >> (strip * TILE_BLOCKS) & ((1u << TILE_BLOCKS) - 1);
  if (!here) return;
  LayerPlanes* planes = layers->planes;
  for (int i = 0; i < STRIP_ROWS; i++) {
    LayeredRow* row = &layers->rows[i];
    for (int sample = 0; sample < SAMPLES; sample++) {
      row->red[sample] = row->green[sample] = row->blue[sample] = 0.0f;
      row->transmittance[sample] = 1.0f;
      row->id[sample] = NO_ID;
    }
#if SAMPLES == 1
    row->depth = FARTHEST_DEPTH;
#endif
  }
  planes->more = true;
  for (planes->pass = 0; planes->more; planes->pass++) {
    sort_layers(planes, lists, tile, blocks, strip);
    for (int column = 0; column < TILE_BLOCKS; column++)
      if (here >> column & 1u)
        blend_block(s, planes, column, rows, tile.x + column * TILE_BLOCK, tile.y + strip * TILE_BLOCK, layers->rows);
    if (!planes->more) break;
    for (int i = 0; i < STRIP_VECTORS; i++) {
      const bool full = planes->count[i] == MAX_PLANES;
      const uint last = planes->order[i][MAX_PLANES - 1] * STRIP_VECTORS + i;
      planes->last_depth[i] = full ? planes->depth[last] : (Depths)(FARTHEST_DEPTH);
      planes->last_rank[i] = full ? planes->rank[last] : (uint16)(0u);
    }
  }
}

// Leaves what the rows of blocks with layers show in a tile's table of ids, and their coverage behind it.
COMPILED_ONCE void store_layered_ids(const Layers* layers, Tile tile, int strip, int rows, global TileIds* out) {
  global uint* ids = (global uint*)(out + 1);
  global float* coverage = coverage_of_tile(out, SAMPLES);
  out->layered = strip == 0 ? layers->blocks : out->layered;
  for (int column = 0; column < TILE_BLOCKS; column++) {
    const int block = strip * TILE_BLOCKS + column;
    if (!(layers->blocks >> block & 1u)) continue;
    for (int row = 0; row < rows; row++) {
      const LayeredRow* layered = &layers->rows[column * TILE_BLOCK + row];
      uint16 opaque[SAMPLES];
      for (int k = 0; k < SAMPLES; k++) opaque[k] = tile.id[vector_in_tile(block, row, k)];
#if SAMPLES > 1
      split_samples(opaque);
#endif
      float16 sum = 0.0f, through_layers = 0.0f;
      const uint at = (uint)(block * TILE_BLOCK + row) * TILE_BLOCK;
      for (int i = 0; i < SAMPLES; i++) {
        const int16 empty = opaque[i] == NO_ID;
        sum = select(sum + 1.0f, sum, empty);
        through_layers = select(through_layers, through_layers + (1.0f - layered->transmittance[i]), empty);
        const Lanes shown = lanes_of(select(layered->id[i], opaque[i], as_uint16(layered->id[i] == NO_ID)));
        for (int pixel = 0; pixel < LANES; pixel++) ids[(at + (uint)pixel) * SAMPLES + (uint)i] = shown.lane[pixel];
      }
      vstore16((sum + through_layers) * (1.0f / SAMPLES), 0, coverage + at);
    }
  }
}

#endif
