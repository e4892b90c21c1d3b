// What the pixels or samples of a tile show, left in the bins for shade_channels. channel_layout.h draws the tables.

#ifndef MORPHCL_TILE_IDS_H
#define MORPHCL_TILE_IDS_H

#include "layout.h"
#include "tables.h"
#include "tile.h"
#include "vector.h"

// A call, so that frames without these channels have no more than a branch.
COMPILED_ONCE void store_ids(Tile tile, uint16 content, uint left_as_it_is, global const LargeTriangle* large,
                             global TileIds* out) {
  const Lanes of_block = lanes_of(content);
  global uint16* ids = (global uint16*)(out + 1);
  out->left_as_it_is = left_as_it_is;
  out->layered = 0;
  for (int block = 0; block < LANES; block++) {
    const uint held = of_block.lane[block];
    out->content[block] = held == CLEAR ? NO_ID : held == PER_PIXEL ? MIXED_IDS : large[held].id;
    if (held != PER_PIXEL) continue;
    for (int row = 0; row < TILE_BLOCK; row++)
      for (int k = 0; k < SAMPLES; k++) {
#if SAMPLES == 1
        const uint16 shown = tile.id[(row_of(block) + row) * ROW_VECTORS + column_of(block) / LANES];
#else
        const uint16 shown = tile.id[block * BLOCK_VECTORS + row * SAMPLES + k];
#endif
        ids[(block * TILE_BLOCK + row) * SAMPLES + k] = shown;
      }
  }
}

#endif
