// Small triangles, one a lane, at the samples of the pixels in their boxes. A part of bin_primitives.h.
//
// A pixel's samples give one fragment, with a bit for each that is covered and the plane of depth at the pixel's
// centre.

#ifndef MORPHCL_SMALL_TRIANGLE_SAMPLES_H
#define MORPHCL_SMALL_TRIANGLE_SAMPLES_H

// Where the fragments' depths come from.
#ifdef FORWARD_DEPTH
// Keys are no plane: each sample has a fragment of its own.
static inline void add_fragments(Bins* bins, const SmallPlanes* planes, SmallRow row, int column, uint16 mask, int16 x,
                                 int16 y, uint first_id) {
  const Lanes covered = lanes_of(mask), column_of_lane = lanes_of(as_uint16(x)), row_of_lane = lanes_of(as_uint16(y));
  for (int s = 0; s < SAMPLES; s++) {
    SmallRow sample = row;
    sample.part1 += (planes->part1_dx * sample_x[s] + planes->part1_dy * sample_y[s]) / (SUBPIXELS / SAMPLE_UNIT);
    sample.part2 += (planes->part2_dx * sample_x[s] + planes->part2_dy * sample_y[s]) / (SUBPIXELS / SAMPLE_UNIT);
    int16 here = (mask & (1u << s)) != 0;
    const Lanes depth = lanes_of(as_uint16(small_depths(planes, sample, column, &here)));
    FOR_EACH_LANE(lane, here)
    add_fragment(bins, (int)column_of_lane.lane[lane], (int)row_of_lane.lane[lane], depth.lane[lane], 0.0f, 0.0f,
                 1u << s, first_id + (uint)lane * PIECES);
  }
}
#else
static inline void add_fragments(Bins* bins, const SmallPlanes* planes, SmallRow row, int column, uint16 mask, int16 x,
                                 int16 y, uint first_id) {
  int16 covered = mask != 0;
  const Lanes depth = lanes_of(as_uint16(small_depths(planes, row, column, &covered))),
              depth_dx = lanes_of(as_uint16(planes->dx)), depth_dy = lanes_of(as_uint16(planes->dy));
  const Lanes tile = lanes_of(as_uint16((y >> TILE_BITS) * bins->tiles_x + (x >> TILE_BITS)));
  const int16 in_x = x & (TILE - 1), in_y = y & (TILE - 1);
  const int16 place = ((in_y / TILE_BLOCK * TILE_BLOCKS + in_x / TILE_BLOCK) << 8) | ((in_y & (TILE_BLOCK - 1)) << 4) |
                      (in_x & (TILE_BLOCK - 1));
  const Lanes place_and_mask = lanes_of(as_uint16(place) | mask << PLACE_IN_TILE_BITS);
  FOR_EACH_LANE(lane, covered) {
    const uint at = next_entry(&bins->fragments, tile.lane[lane]);
    if (at >= bins->fragments.capacity * PAGE) continue;
    SampleFragment f;
    f.depth = depth.lane[lane];
    f.id = first_id + (uint)lane * PIECES;
    f.depth_dx = as_float(depth_dx.lane[lane]);
    f.depth_dy = as_float(depth_dy.lane[lane]);
    f.place_and_mask = place_and_mask.lane[lane];
    bins->fragments_of_pixels[at] = f;
  }
}
#endif

static inline void rasterize_small_triangles(Bins* bins, Triangles t, int16 area, int16 active, int16 first_x,
                                             int16 first_y, int16 last_x, int16 last_y, uint first_id) {
  const int16 d1x = t.x[1] - t.x[0], d1y = t.y[1] - t.y[0], d2x = t.x[2] - t.x[0], d2y = t.y[2] - t.y[0];
  const int16 d3x = t.x[2] - t.x[1], d3y = t.y[2] - t.y[1];
  const int16 px = first_x * SUBPIXELS + HALF_PIXEL, py = first_y * SUBPIXELS + HALF_PIXEL;
  int16 row0 = edge_values(d1x, d1y, t.x[0], t.y[0], px, py);
  int16 row1 = edge_values(d3x, d3y, t.x[1], t.y[1], px, py);
  int16 row2 = edge_values(-d2x, -d2y, t.x[2], t.y[2], px, py);
  // From the centre to the samples.
  int16 to_sample0[SAMPLES], to_sample1[SAMPLES], to_sample2[SAMPLES];
  for (int s = 0; s < SAMPLES; s++) {
    const int dx = sample_x[s] * SAMPLE_UNIT, dy = sample_y[s] * SAMPLE_UNIT;
    to_sample0[s] = d1x * dy - d1y * dx;
    to_sample1[s] = d3x * dy - d3y * dx;
    to_sample2[s] = d2y * dx - d2x * dy;
  }

  const SmallPlanes planes = small_planes(t, area, px, py, bins->frame);

  const int16 columns = last_x - first_x, rows = last_y - first_y;
  for (int j = 0; j < SMALL_PIXELS; j++) {
    if (!any_lane(active & (rows >= j))) break;
    const int16 row_active = active & (rows >= j) & (first_y >= -j);  // first rows may lie above the image
    const SmallRow row = small_row(&planes, j);
    int16 value0 = row0, value1 = row1, value2 = row2;
    for (int i = 0; i < SMALL_PIXELS; i++) {
      const int16 in_box = row_active & (columns >= i);
      const int16 in_picture = in_box & (first_x >= -i);
      uint16 mask = 0;
      _Pragma("unroll") for (int s = 0; s < SAMPLES; s++) {
        const int16 covered = ((value0 + to_sample0[s]) | (value1 + to_sample1[s]) | (value2 + to_sample2[s])) >= 0;
        mask |= as_uint16(covered) & (1u << s);
      }
      mask &= as_uint16(in_picture);
      if (any_lane(mask != 0)) add_fragments(bins, &planes, row, i, mask, first_x + i, first_y + j, first_id);
      value0 -= d1y * SUBPIXELS;
      value1 -= d3y * SUBPIXELS;
      value2 += d2y * SUBPIXELS;
      if (i + 1 < SMALL_PIXELS && !any_lane(in_box & (columns > i))) break;
    }
    row0 += d1x * SUBPIXELS;
    row1 += d3x * SUBPIXELS;
    row2 -= d2x * SUBPIXELS;
  }
}

#endif
