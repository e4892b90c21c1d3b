// Lambert light of directional, point and spot lights, in eye space, 16 samples at a time.

#ifndef MORPHCL_LIGHT_H
#define MORPHCL_LIGHT_H

#include "layout.h"
#include "tables.h"
#include "vector.h"

typedef struct {
  float16 x, y, z;
} EyeVector;

typedef struct {
  float16 r, g, b;
} Rgb;

ALWAYS_INLINE float16 dot_product(EyeVector a, EyeVector b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

// The share of a spot light that reaches what lies `distance` from it in the direction of -to_light: 1 within its inner
// cone, 0 outside the outer one. Of any finite value where the distance is 0.
ALWAYS_INLINE float16 share_of_spot(global const LightConstants* light, EyeVector to_light, float16 distance) {
  EyeVector beam;
  beam.x = light->beam[0];
  beam.y = light->beam[1];
  beam.z = light->beam[2];
  const float16 cosine = -dot_product(beam, to_light) / select((float16)1.0f, distance, distance > 0.0f);
  const float16 ramp = fma((float16)(light->cone_scale), cosine, (float16)(light->cone_offset));
  const float16 root = min(max(ramp, (float16)0.0f), (float16)1.0f);
  return root * root;
}

// ambient + sum of color * max(cos, 0) (/ distance^2 where the light falls off, * a spot light's share). The normal has
// any length; where it is zero only the ambient light counts.
ALWAYS_INLINE Rgb lambert(global const FrameConstants* frame, EyeVector normal, EyeVector position) {
  global const LightConstants* lights = lights_of(frame);
  const float16 length = sqrt(dot_product(normal, normal));
  const int16 has_normal = length > 0.0f;
  const float16 normal_length = select((float16)1.0f, length, has_normal);
  Rgb sum;
  sum.r = frame->ambient[0];
  sum.g = frame->ambient[1];
  sum.b = frame->ambient[2];
  for (uint i = 0; i < frame->light_count; i++) {
    EyeVector to_light;
    to_light.x = lights[i].vector[0];
    to_light.y = lights[i].vector[1];
    to_light.z = lights[i].vector[2];
    float16 divisor = normal_length, share = 1.0f;
    if (lights[i].is_point) {
      to_light.x -= position.x;
      to_light.y -= position.y;
      to_light.z -= position.z;
      const float16 square = dot_product(to_light, to_light);
      const float16 distance = sqrt(square);
      divisor *= lights[i].falloff ? square * distance : distance;
      if (lights[i].has_cone) share = share_of_spot(&lights[i], to_light, distance);
    }
    const float16 cosine = max(dot_product(normal, to_light), (float16)0.0f);
    float16 lit = select((float16)0.0f, cosine / divisor, has_normal & (divisor > 0.0f));
    if (lights[i].has_cone) lit *= share;
    sum.r = fma((float16)(lights[i].color[0]), lit, sum.r);
    sum.g = fma((float16)(lights[i].color[1]), lit, sum.g);
    sum.b = fma((float16)(lights[i].color[2]), lit, sum.b);
  }
  return sum;
}

#endif
