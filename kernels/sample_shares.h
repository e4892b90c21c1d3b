// What the samples of pixels are shared out to: coverage, and the ranks of Cryptomatte.
//
// The samples of a pixel are put together by name, as names have one id each. Ranks are sorted by the number of
// samples; of equal ones the name that is drawn first comes first: that of the first draw among the pixel's samples. A
// pixel has six ranks; what is beyond is lost. A share is a number of samples over that of all, and so exact.

#ifndef MORPHCL_SAMPLE_SHARES_H
#define MORPHCL_SAMPLE_SHARES_H

#include "layout.h"
#include "shade_channels.h"

#define CRYPTO_PLANES (2 * CRYPTO_RANKS)

typedef struct {
  float plane[CRYPTO_PLANES][LANES];  // id, share, id, share, ...
} CryptoRow;

ALWAYS_INLINE float crypto_id(global const ChannelDraw* draw, bool of_objects) {
  return of_objects ? draw->crypto_object : draw->crypto_material;
}

// Number of the draw that a sample shows.
ALWAYS_INLINE uint number_of_draw(const ChannelShader* s, uint id) {
  return s->shader.draw_of_group[id / (PIECES * LANES)];
}

static inline void rank_pixel(const ChannelShader* s, global const uint* ids, int pixel, bool of_objects,
                              CryptoRow* row) {
  const uint samples = s->channels->samples;
  uint bits[MAX_SAMPLES], count[MAX_SAMPLES], first[MAX_SAMPLES];  // of each name: its id, samples, first draw
  uint names = 0;
  for (uint i = 0; i < samples; i++) {
    if (ids[i] == NO_ID) continue;
    const uint number = number_of_draw(s, ids[i]), own = as_uint(crypto_id(&s->draws[number], of_objects));
    uint at = 0;
    while (at < names && bits[at] != own) at++;
    if (at == names) {
      bits[at] = own;
      count[at] = 0;
      first[at] = number;
      names++;
    }
    count[at]++;
    first[at] = min(first[at], number);
  }
  const float share = 1.0f / (float)samples;
  for (uint rank = 0; rank < CRYPTO_RANKS; rank++) {
    uint best = 0;
    for (uint at = 1; at < names; at++)
      if (count[at] > count[best] || (count[at] == count[best] && first[at] < first[best])) best = at;
    const bool is_any = best < names && count[best] > 0;
    row->plane[2 * rank][pixel] = is_any ? as_float(bits[best]) : 0.0f;
    row->plane[2 * rank + 1][pixel] = is_any ? (float)count[best] * share : 0.0f;
    if (is_any) count[best] = 0;  // taken
  }
}

// Whether all samples of 16 pixels show nothing or this draw.
static inline bool show_one_draw(const ChannelShader* s, global const uint16* ids, global const DrawConstants* draw) {
  const uint low = draw->first_primitive_group * (PIECES * LANES),
             high = low + (draw->primitive_group_count * (PIECES * LANES) - 1);
  int16 others = 0;
  for (uint k = 0; k < s->channels->samples; k++) others |= (ids[k] != NO_ID) & ((ids[k] < low) | (ids[k] > high));
  return !any_lane(others);
}

// The share of each pixel's samples that show something, of 16 pixels; `any_id` is then one of their ids.
static inline float16 covered_shares(const ChannelShader* s, global const uint* ids, uint* any_id) {
  const uint samples = s->channels->samples;
  uint count[LANES];
  *any_id = NO_ID;
  for (uint pixel = 0; pixel < LANES; pixel++) {
    count[pixel] = 0;
    for (uint i = 0; i < samples; i++) {
      const uint id = ids[pixel * samples + i];
      if (id == NO_ID) continue;
      count[pixel]++;
      *any_id = id;
    }
  }
  return convert_float16(vload16(0, count)) * (1.0f / (float)samples);
}

// One name in all of 16 pixels, with these shares.
static inline void rank_name(float id, float16 shares, CryptoRow* row) {
  for (int plane = 0; plane < CRYPTO_PLANES; plane++) vstore16((float16)(0.0f), 0, row->plane[plane]);
  vstore16(select((float16)(0.0f), (float16)(id), shares > 0.0f), 0, row->plane[0]);
  vstore16(shares, 0, row->plane[1]);
}

#endif
