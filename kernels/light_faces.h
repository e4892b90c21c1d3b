// light_faces: one colour for each triangle of flat draws: base colour times light, from its normal after morphing. Or
// that normal, of draws that are lit per pixel.
//
// In:  attributes of flat draws (morphed positions in object space), indices, draws, lights.
// Out: face_colors[number] float4 {r, g, b, unused}: base colour times the sum of the ambient light and what every
//      light gives at the triangle's centre. Or {x, y, z, unused}: the normal in eye space, its largest component 1.
// Steps, 16 triangles at a time: 1 cross product of two edges in object space, 2 to eye space, unit length, 3 on a
// double-sided draw turn it towards the eye, 4 add up the lights. A triangle without area gets the ambient light.
// One work-item walks a chunk of primitive groups.

#ifndef MORPHCL_LIGHT_FACES_H
#define MORPHCL_LIGHT_FACES_H

#include "layout.h"
#include "light.h"
#include "tables.h"
#include "vector.h"

COMPILED_ONCE void light_chunk(uint chunk, global const FrameConstants* restrict frame,
                               global const DrawConstants* restrict draws, global const uint* restrict indices,
                               global const int4* restrict attributes, global int4* restrict face_colors) {
  const GroupRange groups = primitive_groups_of(chunk, frame);
  for (uint group = groups.first; group < groups.end; group++) {
    global const DrawConstants* draw = &draws[draw_of_primitive_group(draws, frame)[group]];
    if (!(draw->flags & DRAW_FLAT)) continue;
    global const uint* corner_a = indices + draw->indices + (group - draw->first_primitive_group) * LANES;
    global const uint* corner_b = corner_a + draw->index_pitch;
    global const uint* corner_c = corner_b + draw->index_pitch;
    global const int4* positions = attributes + (size_t)draw->first_vertex_group * LANES;
    int16 x0, y0, z0, x1, y1, z1, x2, y2, z2, unused;
    GATHER_RECORDS(positions, corner_a, x0, y0, z0, unused)
    GATHER_RECORDS(positions, corner_b, x1, y1, z1, unused)
    GATHER_RECORDS(positions, corner_c, x2, y2, z2, unused)
    const float16 ax = as_float16(x0), ay = as_float16(y0), az = as_float16(z0);
    const float16 ux = as_float16(x1) - ax, uy = as_float16(y1) - ay, uz = as_float16(z1) - az;
    const float16 vx = as_float16(x2) - ax, vy = as_float16(y2) - ay, vz = as_float16(z2) - az;
    const float16 cross_x = difference_of_products(uy, vz, uz, vy);
    const float16 cross_y = difference_of_products(uz, vx, ux, vz);
    const float16 cross_z = difference_of_products(ux, vy, uy, vx);
    EyeVector normal;
    normal.x = row_times_vector(draw->normal_to_eye[0], cross_x, cross_y, cross_z);
    normal.y = row_times_vector(draw->normal_to_eye[1], cross_x, cross_y, cross_z);
    normal.z = row_times_vector(draw->normal_to_eye[2], cross_x, cross_y, cross_z);
    // Scaled by its largest component first: the squares of tiny or huge faces stay in range.
    const float16 largest = max(fabs(normal.x), max(fabs(normal.y), fabs(normal.z)));
    const float16 scale = select((float16)1.0f, largest, largest > 0.0f);
    normal.x /= scale;
    normal.y /= scale;
    normal.z /= scale;

    const float16 third = 1.0f / 3.0f;
    const float16 mid_x = ax + (ux + vx) * third, mid_y = ay + (uy + vy) * third, mid_z = az + (uz + vz) * third;
    EyeVector centre;
    centre.x = row_times_point(draw->object_to_eye[0], mid_x, mid_y, mid_z);
    centre.y = row_times_point(draw->object_to_eye[1], mid_x, mid_y, mid_z);
    centre.z = row_times_point(draw->object_to_eye[2], mid_x, mid_y, mid_z);
    if (draw->flags & DRAW_DOUBLE_SIDED) {
      // Along the line of sight through the face, away from the viewer.
      EyeVector away = centre;
      if (frame->camera.parallel) {
        away.x = frame->camera.slant[0];
        away.y = frame->camera.slant[1];
        away.z = -1.0f;
      }
      const int16 back = dot_product(normal, away) > 0.0f;
      normal.x = select(normal.x, -normal.x, back);
      normal.y = select(normal.y, -normal.y, back);
      normal.z = select(normal.z, -normal.z, back);
    }
    if (draw->flags & DRAW_LIT_PER_PIXEL) {
      store_records(as_int16(normal.x), as_int16(normal.y), as_int16(normal.z), (int16)0,
                    face_colors + (size_t)group * LANES);
      continue;
    }
    const Rgb light = lambert(frame, normal, centre);
    store_records(as_int16(light.r * draw->base_color[0]), as_int16(light.g * draw->base_color[1]),
                  as_int16(light.b * draw->base_color[2]), (int16)0, face_colors + (size_t)group * LANES);
  }
}

#endif
