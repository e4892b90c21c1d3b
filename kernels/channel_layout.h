// What host and kernels share about channels beside colour and distance: tables of ids, and what shade_channels is
// told. A part of layout.h.
//
// The tables of ids say what each pixel's centre, or each of its samples, shows: one table a tile of the band that is
// being drawn, in the order of its tiles.
//
//     TileIds                                     ids that a block's content says nothing about: uint[4096 * samples]
//     | content[16] | left_as_it_is | padding |   block 0: row 0: pixel 0: its samples, pixel 1: ...; row 1 ... | block
//     1

#ifndef MORPHCL_CHANNEL_LAYOUT_H
#define MORPHCL_CHANNEL_LAYOUT_H

// Bit of a channel in a set: 1 << its number in include/morphcl/channel.hpp.
#define CHANNELS 12
#define CHANNEL_NORMAL 2
#define CHANNEL_POSITION 3
#define CHANNEL_VELOCITY 4
#define CHANNEL_UV 5
#define CHANNEL_ALBEDO 6
#define CHANNEL_OBJECT_ID 7
#define CHANNEL_MATERIAL_ID 8
#define CHANNEL_COVERAGE 9
#define CHANNEL_CRYPTO_OBJECT 10
#define CHANNEL_CRYPTO_MATERIAL 11

#define CRYPTO_RANKS 6  // pairs of id and coverage
#define MIXED_IDS (NO_ID - 1)

typedef struct {
  uint content[LANES];  // of each block: an id or NO_ID, which all of it shows, or MIXED_IDS: ids stand in the table
  uint left_as_it_is;   // blocks that were and stay background, as mark_blank_blocks() has them
  uint layered;         // of frames that blend: blocks whose coverage stands behind the ids, a float a pixel
  uint pad[14];
} TileIds;

// Where a frame's channels are, and what takes them from eye space to the world.
typedef struct {
  uint channels;                // that are made from these ids: bits
  uint samples;                 // ids a pixel
  uint offset[CHANNELS];        // bytes from the start of a row to each channel's first plane
  uint half_plane, word_plane;  // bytes from a plane to the next, of halves and of floats or uints
  float eye_to_world[3][4];
  // Where tables begin, in words from the start of `frame`: ChannelDraw of each draw; and of the next frame, for
  // velocity: DrawConstants, TargetConstants and PreciseConstants.
  uint draws, next_draws, next_targets, next_precise;
} ChannelConstants;

typedef struct {
  float albedo[4];
  uint object_id, material_id;
  float crypto_object, crypto_material;
  uint uvs;    // float index of u in the mesh data, v follows at distance `pitch`; NO_ID: the mesh has none
  uint moves;  // 0: in the next frame all of it is where it is now
  uint pad[2];
} ChannelDraw;

#endif
