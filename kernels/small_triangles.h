// Small triangles, one a lane, at the centres of the pixels in their boxes. A part of bin_primitives.h.

#ifndef MORPHCL_SMALL_TRIANGLES_H
#define MORPHCL_SMALL_TRIANGLES_H

static inline void rasterize_small_triangles(Bins* bins, Triangles t, int16 area, int16 active, int16 first_x,
                                             int16 first_y, int16 last_x, int16 last_y, uint first_id) {
  const int16 d1x = t.x[1] - t.x[0], d1y = t.y[1] - t.y[0], d2x = t.x[2] - t.x[0], d2y = t.y[2] - t.y[0];
  const int16 d3x = t.x[2] - t.x[1], d3y = t.y[2] - t.y[1];
  const int16 px = first_x * SUBPIXELS + HALF_PIXEL, py = first_y * SUBPIXELS + HALF_PIXEL;
  int16 row0 = edge_values(d1x, d1y, t.x[0], t.y[0], px, py);
  int16 row1 = edge_values(d3x, d3y, t.x[1], t.y[1], px, py);
  int16 row2 = edge_values(-d2x, -d2y, t.x[2], t.y[2], px, py);

  const SmallPlanes planes = small_planes(t, area, px, py, bins->frame);
  // margin_of_edges()
  const uint16 size0 = abs(d1x) + abs(d1y), size1 = abs(d3x) + abs(d3y), size2 = abs(d2x) + abs(d2y);
  const uint16 margin = select(max(size0, max(size1, size2)) * 5 / 8 + 1, (uint16)(NO_MARGIN),
                               min(size0, min(size1, size2)) < SHORT_EDGE);

  const int16 columns = last_x - first_x, rows = last_y - first_y;
  for (int j = 0; j < SMALL_PIXELS; j++) {
    if (!any_lane(active & (rows >= j))) break;
    const int16 row_active = active & (rows >= j) & (first_y >= -j);  // first rows may lie above the image
    const SmallRow row = small_row(&planes, j);
    int16 value0 = row0, value1 = row1, value2 = row2;
    for (int i = 0; i < SMALL_PIXELS; i++) {
      const int16 in_box = row_active & (columns >= i);
      const int16 min_value = min(value0, min(value1, value2));
      int16 covered = in_box & (first_x >= -i) & (min_value >= 0);
      if (any_lane(covered)) {
        const int16 x = first_x + i, y = first_y + j;
        const int16 beside_edges = covered & (as_uint16(min_value) < margin);
        const Depths depth = any_lane(beside_edges)
                                 ? small_depths_beside_edges(&t, &planes, row, i, x * SUBPIXELS + HALF_PIXEL,
                                                             y * SUBPIXELS + HALF_PIXEL, &covered)
                                 : small_depths(&planes, row, i, &covered);
        uint depth_bits[LANES];
        int tile[LANES], place[LANES];
        vstore16(as_uint16(depth), 0, depth_bits);
        vstore16((y >> TILE_BITS) * bins->tiles_x + (x >> TILE_BITS), 0, tile);
        vstore16(((y & (TILE - 1)) << TILE_BITS) | (x & (TILE - 1)), 0, place);
        FOR_EACH_LANE(lane, covered) {
          const uint at = next_entry(&bins->fragments, (uint)tile[lane]);
          if (at >= bins->fragments.capacity * PAGE) continue;
          bins->fragments_of_pixels[at] = ((ulong)depth_bits[lane] << 32) | (first_id + (uint)lane * PIECES);
          bins->fragment_places[at] = (ushort)place[lane];
        }
      }
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
