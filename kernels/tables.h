// The tables that share a buffer, by name: what stands behind the constants in `frame` and `draws`, and the bins.

#ifndef MORPHCL_TABLES_H
#define MORPHCL_TABLES_H

#include "layout.h"
#include "vector.h"

// ---- frame and draws ------------------------------------------------------------------------------------------------

ALWAYS_INLINE global const LightConstants* lights_of(global const FrameConstants* frame) {
  return (global const LightConstants*)((global const uint*)frame + frame->lights);
}
// Of this many work-items the chunks of vertices that are to be projected.
ALWAYS_INLINE global const uint* changed_vertex_chunks(global const FrameConstants* frame) {
  return (global const uint*)frame + frame->changed_vertex_chunks;
}
ALWAYS_INLINE global const PreciseConstants* precise_constants(global const FrameConstants* frame) {
  return (global const PreciseConstants*)((global const uint*)frame + frame->precise);
}
// Of each row of the picture, where there is a background.
ALWAYS_INLINE global const ushort4* background_rows(global const FrameConstants* frame) {
  return (global const ushort4*)((global const uint*)frame + frame->background);
}

// Of channels beside colour and distance.
ALWAYS_INLINE global const ChannelConstants* channel_constants(global const FrameConstants* frame) {
  return (global const ChannelConstants*)((global const uint*)frame + frame->channels);
}
ALWAYS_INLINE global const ChannelDraw* channel_draws(global const FrameConstants* frame) {
  return (global const ChannelDraw*)((global const uint*)frame + channel_constants(frame)->draws);
}
ALWAYS_INLINE global const DrawConstants* next_draws(global const FrameConstants* frame) {
  return (global const DrawConstants*)((global const uint*)frame + channel_constants(frame)->next_draws);
}
ALWAYS_INLINE global const TargetConstants* next_targets(global const FrameConstants* frame) {
  return (global const TargetConstants*)((global const uint*)frame + channel_constants(frame)->next_targets);
}
ALWAYS_INLINE global const PreciseConstants* next_precise(global const FrameConstants* frame) {
  return (global const PreciseConstants*)((global const uint*)frame + channel_constants(frame)->next_precise);
}

// Index of the draw that a group of vertices or of primitives belongs to, and of the one that is binned at a place in
// the order of binning.
ALWAYS_INLINE global const uint* draw_of_vertex_group(global const DrawConstants* draws,
                                                      global const FrameConstants* frame) {
  return (global const uint*)draws + frame->draw_of_vertex_group;
}
ALWAYS_INLINE global const uint* draw_of_primitive_group(global const DrawConstants* draws,
                                                         global const FrameConstants* frame) {
  return (global const uint*)draws + frame->draw_of_primitive_group;
}
ALWAYS_INLINE global const uint* draw_in_order(global const DrawConstants* draws, global const FrameConstants* frame) {
  return (global const uint*)draws + frame->draw_in_order;
}

// The primitive groups of a chunk: those numbered, or in the order of binning, from first to before end.
typedef struct {
  uint first, end;
} GroupRange;
ALWAYS_INLINE GroupRange primitive_groups_of(uint chunk, global const FrameConstants* frame) {
  GroupRange groups;
  groups.first = chunk * frame->primitive_groups_per_chunk;
  groups.end = min(groups.first + frame->primitive_groups_per_chunk, frame->primitive_group_count);
  return groups;
}

// ---- bins -----------------------------------------------------------------------------------------------------------

ALWAYS_INLINE global ChunkStatus* chunk_status(global BinsHeader* bins, global const FrameConstants* frame) {
  return (global ChunkStatus*)((global char*)bins + frame->bins.chunk_status);
}
ALWAYS_INLINE global uint* vertex_chunk_status(global BinsHeader* bins, global const FrameConstants* frame) {
  return (global uint*)((global char*)bins + frame->bins.vertex_chunk_status);
}

// The ids of a tile, by its place in the band being drawn.
ALWAYS_INLINE global TileIds* ids_of_tile(uint place, global BinsHeader* bins, global const FrameConstants* frame) {
  const size_t words = channel_constants(frame)->samples + (frame->blends ? 1 : 0);
  const size_t bytes = sizeof(TileIds) + TILE * TILE * sizeof(uint) * words;
  return (global TileIds*)((global char*)bins + frame->bins.ids + place * bytes);
}

ALWAYS_INLINE global float* coverage_of_tile(global TileIds* ids, uint samples) {
  return (global float*)((global uint*)(ids + 1) + TILE * TILE * samples);
}

#if SAMPLES == 1
typedef ulong Fragment;  // bits of depth << 32 | id
#else
typedef SampleFragment Fragment;
#endif

// What one chunk puts into its bins, and the tiles take out of them: lists of fragments {depth, id, place in the tile}
// and of entries, one a large triangle and tile.
typedef struct {
  global uint *fragment_heads, *fragment_next;
  global Fragment* fragments;
  global ushort* fragment_places;  // row << TILE_BITS | column in the tile; of one sample a pixel
  global uint *entry_heads, *entry_next;
  global uint *blended_fragment_heads, *blended_entry_heads;  // lists of blended draws, on the same pages
  global uint* entry_triangles;  // index into the chunk's large triangles, perhaps with ENTIRE_TILE
  global LargeTriangle* large;
} ChunkBins;

ALWAYS_INLINE ChunkBins bins_of_chunk(uint chunk, global const FrameConstants* frame, global BinsHeader* bins,
                                      global Fragment* fragments, global LargeTriangle* large) {
  global char* bytes = (global char*)bins;
  const size_t tile = (size_t)chunk * (uint)(frame->tiles_x * frame->tiles_y);
  const size_t fragment_page = (size_t)chunk * frame->fragment_pages, entry_page = (size_t)chunk * frame->entry_pages;
  ChunkBins own;
  own.fragment_heads = (global uint*)(bytes + frame->bins.fragment_heads) + tile;
  own.fragment_next = (global uint*)(bytes + frame->bins.fragment_next) + fragment_page;
  own.fragments = fragments + fragment_page * PAGE;
  own.fragment_places = (global ushort*)(bytes + frame->bins.fragment_places) + fragment_page * PAGE;
  own.entry_heads = (global uint*)(bytes + frame->bins.entry_heads) + tile;
  own.blended_fragment_heads = (global uint*)(bytes + frame->bins.blended_fragment_heads) + tile;
  own.blended_entry_heads = (global uint*)(bytes + frame->bins.blended_entry_heads) + tile;
  own.entry_next = (global uint*)(bytes + frame->bins.entry_next) + entry_page;
  own.entry_triangles = (global uint*)(bytes + frame->bins.entry_triangles) + entry_page * PAGE;
  own.large = large + (size_t)chunk * frame->large_capacity;
  return own;
}

#endif
