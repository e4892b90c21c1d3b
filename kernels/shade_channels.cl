#pragma OPENCL FP_CONTRACT OFF
// shade_channels: the channels beside colour and distance, from the ids that shade_tiles left of the pixels' centres,
// or shade_samples of their samples.
//
// In:  the tables of ids of the band just drawn, vertices, attributes, colours, clipped primitives, draws, mesh data
// for
//      texture coordinates, motion for velocity.
// Out: the picture's planes of the channels that are made from these ids: N, albedo as half; P, velocity, uv, coverage
//      and Cryptomatte as float; ids as uint; 0 where nothing is drawn.
// Steps for each row of 16 pixels: of centres 1 find the place in the primitive, 2 sum up the vertices' values there;
//   of samples 1 count them, 2 put them together by name; store. Blocks that were and stay background are left as they
//   are.
// One work-item makes the pixels of a tile, in launches as of shade_tiles. How many samples a pixel has is no option of
// the compiler here.

#include "layout.h"
#include "sample_shares.h"
#include "shade_channels.h"
#include "tables.h"
#include "tile_pixels.h"
#include "vector.h"

// The place of 16 pixels in the planes.
typedef struct {
  global uchar* row;  // of the picture
  uint column;
  global const ChannelConstants* channels;
} PlaneRow;

ALWAYS_INLINE void store_halves(PlaneRow to, uint channel, uint plane, float16 value) {
  vstore16(to_halves(value), 0,
           (global ushort*)(to.row + to.channels->offset[channel] + plane * to.channels->half_plane) + to.column);
}
ALWAYS_INLINE void store_words(PlaneRow to, uint channel, uint plane, int16 value) {
  STREAM_STORE(value,
               (global int16*)((global int*)(to.row + to.channels->offset[channel] + plane * to.channels->word_plane) +
                               to.column));
}

ALWAYS_INLINE void store_centres(const ChannelShader* s, PlaneRow to, Centres centres) {
  if (makes(s, CHANNEL_NORMAL)) {
    store_halves(to, CHANNEL_NORMAL, 0, centres.normal.x);
    store_halves(to, CHANNEL_NORMAL, 1, centres.normal.y);
    store_halves(to, CHANNEL_NORMAL, 2, centres.normal.z);
  }
  if (makes(s, CHANNEL_POSITION)) {
    store_words(to, CHANNEL_POSITION, 0, as_int16(centres.position.x));
    store_words(to, CHANNEL_POSITION, 1, as_int16(centres.position.y));
    store_words(to, CHANNEL_POSITION, 2, as_int16(centres.position.z));
  }
  if (makes(s, CHANNEL_VELOCITY)) {
    store_words(to, CHANNEL_VELOCITY, 0, as_int16(centres.velocity_u));
    store_words(to, CHANNEL_VELOCITY, 1, as_int16(centres.velocity_v));
  }
  if (makes(s, CHANNEL_UV)) {
    store_words(to, CHANNEL_UV, 0, as_int16(centres.u));
    store_words(to, CHANNEL_UV, 1, as_int16(centres.v));
  }
  if (makes(s, CHANNEL_ALBEDO)) {
    store_halves(to, CHANNEL_ALBEDO, 0, centres.albedo.r);
    store_halves(to, CHANNEL_ALBEDO, 1, centres.albedo.g);
    store_halves(to, CHANNEL_ALBEDO, 2, centres.albedo.b);
  }
  if (makes(s, CHANNEL_OBJECT_ID)) store_words(to, CHANNEL_OBJECT_ID, 0, as_int16(centres.object_id));
  if (makes(s, CHANNEL_MATERIAL_ID)) store_words(to, CHANNEL_MATERIAL_ID, 0, as_int16(centres.material_id));
}

ALWAYS_INLINE void store_ranks(PlaneRow to, uint channel, const CryptoRow* row) {
  for (uint plane = 0; plane < CRYPTO_PLANES; plane++)
    store_words(to, channel, plane, as_int16(vload16(0, row->plane[plane])));
}

// Of a row that shows one id or nothing.
ALWAYS_INLINE void store_shares_of_one(const ChannelShader* s, PlaneRow to, uint id) {
  const float16 shares = id == NO_ID ? 0.0f : 1.0f;
  if (makes(s, CHANNEL_COVERAGE)) store_words(to, CHANNEL_COVERAGE, 0, as_int16(shares));
  for (uint channel = CHANNEL_CRYPTO_OBJECT; channel <= CHANNEL_CRYPTO_MATERIAL; channel++) {
    if (!makes(s, channel)) continue;
    CryptoRow row;
    rank_name(id == NO_ID ? 0.0f : crypto_id(&s->draws[number_of_draw(s, id)], channel == CHANNEL_CRYPTO_OBJECT),
              shares, &row);
    store_ranks(to, channel, &row);
  }
}

// `coverage`: of the 16 pixels, where it is not the share of samples that show something; else null.
ALWAYS_INLINE void store_shares(const ChannelShader* s, PlaneRow to, global const uint* ids,
                                global const float* coverage) {
  const uint samples = s->channels->samples;
  uint any_id;
  const float16 shares = covered_shares(s, ids, &any_id);
  if (makes(s, CHANNEL_COVERAGE))
    store_words(to, CHANNEL_COVERAGE, 0, as_int16(coverage ? vload16(0, coverage) : shares));
  const bool is_one =
      any_id == NO_ID || show_one_draw(s, (global const uint16*)ids, &s->shader.draws[number_of_draw(s, any_id)]);
  for (uint channel = CHANNEL_CRYPTO_OBJECT; channel <= CHANNEL_CRYPTO_MATERIAL; channel++) {
    if (!makes(s, channel)) continue;
    const bool of_objects = channel == CHANNEL_CRYPTO_OBJECT;
    CryptoRow row;
    if (is_one)
      rank_name(any_id == NO_ID ? 0.0f : crypto_id(&s->draws[number_of_draw(s, any_id)], of_objects), shares, &row);
    else
      for (int pixel = 0; pixel < LANES; pixel++) rank_pixel(s, ids + pixel * samples, pixel, of_objects, &row);
    store_ranks(to, channel, &row);
  }
}

#define CHANNELS_OF_SAMPLES (1u << CHANNEL_COVERAGE | 1u << CHANNEL_CRYPTO_OBJECT | 1u << CHANNEL_CRYPTO_MATERIAL)

COMPILED_ONCE void shade_channels_of_tile(uint number, uint first_tile, global const FrameConstants* restrict frame,
                                          const ChannelShader* restrict s, global BinsHeader* restrict bins,
                                          global uchar* restrict picture) {
  const uint tile_x = number % (uint)frame->tiles_x, place = number - first_tile;
  const uint samples = s->channels->samples;
  global const TileIds* tile = ids_of_tile(place, bins, frame);
  global const uint* ids = (global const uint*)(tile + 1);
  global const float* coverage = coverage_of_tile((global TileIds*)tile, samples);
  const int x = (int)tile_x * TILE, y = (int)(number / (uint)frame->tiles_x) * TILE;
  const int rows = min(TILE, frame->height - y);
  const bool of_samples = s->channels->channels & CHANNELS_OF_SAMPLES,
             of_centres = s->channels->channels & ~CHANNELS_OF_SAMPLES;
  PlaneRow to;
  to.channels = s->channels;
  for (int block = 0; block < LANES; block++) {
    if (tile->left_as_it_is >> (block & ~1) & 1u) continue;
    const uint content = tile->content[block];
    const int column = column_of(block), first_row = row_of(block);
    to.column = tile_x * TILE + (uint)column;
    for (int row = first_row; row < min(first_row + TILE_BLOCK, rows); row++) {
      to.row = picture + ((size_t)(place / (uint)frame->tiles_x) * TILE + (size_t)row) * frame->row_bytes;
      const uint row_in_tile = (uint)block * TILE_BLOCK + (uint)(row - first_row);
      global const uint* of_row = ids + row_in_tile * (TILE_BLOCK * samples);
      if (of_centres)
        store_centres(
            s, to, centres_of(s, content == MIXED_IDS ? vload16(0, of_row) : (uint16)(content), x + column, y + row));
      if (!of_samples) continue;
      if (content == MIXED_IDS)
        store_shares(s, to, of_row, tile->layered >> block & 1u ? coverage + row_in_tile * TILE_BLOCK : 0);
      else
        store_shares_of_one(s, to, content);
    }
  }
}

kernel void shade_channels(global const FrameConstants* frame, global const DrawConstants* draws,
                           global const uint* indices, global const float* mesh_data, global const int4* vertices,
                           global const int4* attributes, global const int4* colors, global const int4* motion,
                           global const ClippedPrimitive* clipped, global BinsHeader* bins, global uchar* picture) {
  if (bins->overflow) return;  // so are the tables of ids
  ChannelShader s;
  s.shader = shader_of(frame, draws, indices, vertices, attributes, colors, 0, clipped, bins);
  s.channels = channel_constants(frame);
  s.draws = channel_draws(frame);
  s.mesh_data = mesh_data;
  s.motion = motion;
  s.vertex_count = (size_t)frame->vertex_group_count * LANES;
  shade_channels_of_tile((uint)get_global_id(0), (uint)get_global_offset(0), frame, &s, bins, picture);
}
