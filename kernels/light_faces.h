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

// Of 16 triangles, from their morphed corners in object space.
typedef struct {
  EyeVector normal;  // its largest component is 1 or -1; zero without area. Towards the eye on a double-sided draw
  EyeVector centre;
} Faces;

ALWAYS_INLINE Faces faces_of(global const FrameConstants* frame, global const DrawConstants* draw, EyeVector a,
                             EyeVector b, EyeVector c) {
  Faces face;
  const float16 ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const float16 vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const float16 cross_x = difference_of_products(uy, vz, uz, vy);
  const float16 cross_y = difference_of_products(uz, vx, ux, vz);
  const float16 cross_z = difference_of_products(ux, vy, uy, vx);
  face.normal.x = row_times_vector(draw->normal_to_eye[0], cross_x, cross_y, cross_z);
  face.normal.y = row_times_vector(draw->normal_to_eye[1], cross_x, cross_y, cross_z);
  face.normal.z = row_times_vector(draw->normal_to_eye[2], cross_x, cross_y, cross_z);
  // Scaled by its largest component first: the squares of tiny or huge faces stay in range.
  const float16 largest = max(fabs(face.normal.x), max(fabs(face.normal.y), fabs(face.normal.z)));
  const float16 scale = select((float16)1.0f, largest, largest > 0.0f);
  face.normal.x /= scale;
  face.normal.y /= scale;
  face.normal.z /= scale;

  const float16 third = 1.0f / 3.0f;
  const float16 mid_x = a.x + (ux + vx) * third, mid_y = a.y + (uy + vy) * third, mid_z = a.z + (uz + vz) * third;
  face.centre.x = row_times_point(draw->object_to_eye[0], mid_x, mid_y, mid_z);
  face.centre.y = row_times_point(draw->object_to_eye[1], mid_x, mid_y, mid_z);
  face.centre.z = row_times_point(draw->object_to_eye[2], mid_x, mid_y, mid_z);
  if (draw->flags & DRAW_DOUBLE_SIDED) {
    // Along the line of sight through the face, away from the viewer.
    EyeVector away = face.centre;
    if (frame->camera.parallel) {
      away.x = frame->camera.slant[0];
      away.y = frame->camera.slant[1];
      away.z = -1.0f;
    }
    const int16 back = dot_product(face.normal, away) > 0.0f;
    face.normal.x = select(face.normal.x, -face.normal.x, back);
    face.normal.y = select(face.normal.y, -face.normal.y, back);
    face.normal.z = select(face.normal.z, -face.normal.z, back);
  }
  return face;
}

ALWAYS_INLINE EyeVector vector_from(int16 x, int16 y, int16 z) {
  EyeVector v;
  v.x = as_float16(x);
  v.y = as_float16(y);
  v.z = as_float16(z);
  return v;
}

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
    const Faces face = faces_of(frame, draw, vector_from(x0, y0, z0), vector_from(x1, y1, z1), vector_from(x2, y2, z2));
    if (draw->flags & DRAW_LIT_PER_PIXEL) {
      store_records(as_int16(face.normal.x), as_int16(face.normal.y), as_int16(face.normal.z), (int16)0,
                    face_colors + (size_t)group * LANES);
      continue;
    }
    const Rgb light = lambert(frame, face.normal, face.centre);
    store_records(as_int16(light.r * draw->base_color[0]), as_int16(light.g * draw->base_color[1]),
                  as_int16(light.b * draw->base_color[2]), (int16)0, face_colors + (size_t)group * LANES);
  }
}

#endif
