// What 16 pixels of a row show beside colour and distance, from the ids at their centres.
//
// A place in a triangle has a share of each of its vertices, in perspective: for corner i the doubled area opposite to
// it over w, over the sum of all three. Of a line the areas are what is left to the other end along its longer axis.
// What clipping cut has its shares at the cut corners turned into shares of the mesh's vertices. Everything but the
// position is the sum of the vertices' values times their shares.
//
//   N         as shading has it, smooth or of the face, scaled by its largest component, to the world, unit length
//   P         the ray through the pixel's centre times the distance, which is the sum of the areas over that of the
//             areas over w, or in parallel projections interpolated; from there to the world
//   velocity  where the place is in the next frame less where it is now, both from unrounded clip coordinates: what
//   does
//             not move has 0

#ifndef MORPHCL_SHADE_CHANNELS_H
#define MORPHCL_SHADE_CHANNELS_H

#include "layout.h"
#include "light.h"
#include "light_faces.h"
#include "shade.h"
#include "tables.h"
#include "vector.h"

typedef struct {
  Shader shader;
  global const ChannelConstants* channels;
  global const ChannelDraw* draws;
  global const float* mesh_data;
  global const int4* motion;
  size_t vertex_count;  // of records, from a vertex in `motion` to the same in the next frame
} ChannelShader;

typedef struct {
  EyeVector normal, position;  // world space
  float16 velocity_u, velocity_v;
  float16 u, v;
  Rgb albedo;
  uint16 object_id, material_id;
} Centres;

ALWAYS_INLINE Centres no_centres(void) {
  Centres centres;
  centres.normal.x = centres.normal.y = centres.normal.z = 0.0f;
  centres.position = centres.normal;
  centres.velocity_u = centres.velocity_v = centres.u = centres.v = 0.0f;
  centres.albedo.r = centres.albedo.g = centres.albedo.b = 0.0f;
  centres.object_id = centres.material_id = 0;
  return centres;
}

ALWAYS_INLINE bool makes(const ChannelShader* s, uint channel) { return s->channels->channels >> channel & 1u; }

// The vertices of what pixels show, and where in it their centres are.
typedef struct {
  uint vertex[3][LANES];  // records
  bool same;              // all lanes are as the first
  float16 share[3];
  float16 distance;  // along the view axis
  int16 is_back;     // seen from behind
} Places;

// What is left of a line to its other end, and to this one, along its longer axis.
ALWAYS_INLINE Areas lengths_at(const Surface* surface, int16 px, int16 py) {
  const int16 steep = abs(surface->y[1] - surface->y[0]) > abs(surface->x[1] - surface->x[0]);
  Areas lengths;
  const int16 at = select(px, py, steep) * CORNER_UNITS;
  lengths.corner[0] = convert_float16(select(surface->x[1], surface->y[1], steep) - at);
  lengths.corner[1] = convert_float16(at - select(surface->x[0], surface->y[0], steep));
  lengths.corner[2] = 0.0f;
  return lengths;
}

// The third corner of a line, of which there is none.
ALWAYS_INLINE void drop_third_corner(Surface* surface, float16 depth[3]) {
  surface->x[2] = surface->y[2] = 0;
  surface->inverse_w[2] = depth[2] = 0.0f;
  FOR_THREE(v) surface->cut[2][v] = 0.0f;
}

ALWAYS_INLINE float16 shared(const Places* places, float16 a, float16 b, float16 c) {
  return fma(places->share[0], a, fma(places->share[1], b, places->share[2] * c));
}

// At the centres of 16 pixels from (x, y) on. The ids (the first alone when `same`) all belong to the draw.
ALWAYS_INLINE void find_places(const ChannelShader* s, global const DrawConstants* draw, Lanes id, bool same, int x,
                               int y, Places* places) {
  const Shader* shader = &s->shader;
  const bool lines = draw->flags & DRAW_LINES;
  const uint first_number = draw->first_primitive_group * LANES, first_vertex = draw->first_vertex_group * LANES;
  uint corner[3][LANES];
  places->same = same;
  for (int lane = 0; lane < (same ? 1 : LANES); lane++) FOR_THREE(i)
  corner[i][lane] = places->vertex[i][lane] =
      first_vertex +
      shader->indices[draw->indices + i * draw->index_pitch + ((id.lane[lane] >> PIECE_BITS) - first_number)];
  Surface surface;
  gather_cuts(shader, id, same, corner, &surface);
  float16 depth[3];
  FOR_THREE(i) {
    int16 depth_bits, inverse_w_bits;
    fetch(shader->vertices, corner[i], same, &surface.x[i], &surface.y[i], &depth_bits, &inverse_w_bits);
    depth[i] = as_float16(depth_bits);
    surface.inverse_w[i] = as_float16(inverse_w_bits);
  }
  if (lines) drop_third_corner(&surface, depth);

  const int16 px = (x + LANE) * SUBPIXELS + HALF_PIXEL, py = y * SUBPIXELS + HALF_PIXEL;
  const Areas areas = within_triangle(draw, lines ? lengths_at(&surface, px, py) : areas_at(&surface, px, py));
  const bool parallel = shader->frame->camera.parallel;
  float16 weight[3];
  FOR_THREE(i) weight[i] = areas.corner[i];
  if (!parallel) FOR_THREE(i) weight[i] *= surface.inverse_w[i];
  const float16 total = weight[0] + weight[1] + weight[2];
  places->is_back = draw->flags & DRAW_MIRRORED ? total < 0.0f : total > 0.0f;
  FOR_THREE(i) places->share[i] = weight[i] / total;
  if (parallel) {
    const float16 at = shared(places, depth[0], depth[1], depth[2]);
#ifdef FORWARD_DEPTH
    places->distance = at;
#else
    places->distance = -at;
#endif
  } else {
    places->distance = (areas.corner[0] + areas.corner[1] + areas.corner[2]) / total;
  }
  if (!surface.any_cut) return;
  float16 of_vertex[3];
  FOR_THREE(v) of_vertex[v] = shared(places, surface.cut[0][v], surface.cut[1][v], surface.cut[2][v]);
  FOR_THREE(v) places->share[v] = select(places->share[v], of_vertex[v], surface.is_cut);
}

// ---- one channel each -----------------------------------------------------------------------------------------------

ALWAYS_INLINE EyeVector unit_in_world(global const ChannelConstants* channels, EyeVector normal) {
  const float16 largest = max(fabs(normal.x), max(fabs(normal.y), fabs(normal.z)));
  const float16 scale = select((float16)1.0f, largest, largest > 0.0f);
  normal.x /= scale;
  normal.y /= scale;
  normal.z /= scale;
  EyeVector world;
  world.x = row_times_vector(channels->eye_to_world[0], normal.x, normal.y, normal.z);
  world.y = row_times_vector(channels->eye_to_world[1], normal.x, normal.y, normal.z);
  world.z = row_times_vector(channels->eye_to_world[2], normal.x, normal.y, normal.z);
  const float16 length = sqrt(dot_product(world, world));
  const float16 divisor = select((float16)1.0f, length, length > 0.0f);
  world.x /= divisor;
  world.y /= divisor;
  world.z /= divisor;
  return world;
}

ALWAYS_INLINE EyeVector world_normal(const ChannelShader* s, global const DrawConstants* draw, const Places* places) {
  int16 x[3], y[3], z[3], unused;
  FOR_THREE(i) fetch(s->shader.attributes, places->vertex[i], places->same, &x[i], &y[i], &z[i], &unused);
  EyeVector normal;
  if (draw->flags & DRAW_FACE_NORMALS) {
    normal = faces_of(s->shader.frame, draw, vector_from(x[0], y[0], z[0]), vector_from(x[1], y[1], z[1]),
                      vector_from(x[2], y[2], z[2]))
                 .normal;
  } else {
    normal.x = shared(places, as_float16(x[0]), as_float16(x[1]), as_float16(x[2]));
    normal.y = shared(places, as_float16(y[0]), as_float16(y[1]), as_float16(y[2]));
    normal.z = shared(places, as_float16(z[0]), as_float16(z[1]), as_float16(z[2]));
    if (draw->flags & DRAW_DOUBLE_SIDED) {
      normal.x = select(normal.x, -normal.x, places->is_back);
      normal.y = select(normal.y, -normal.y, places->is_back);
      normal.z = select(normal.z, -normal.z, places->is_back);
    }
  }
  return unit_in_world(s->channels, normal);
}

ALWAYS_INLINE EyeVector world_position(const ChannelShader* s, float16 distance, int px, int py) {
  global const CameraConstants* camera = &s->shader.frame->camera;
  const float16 x = convert_float16(px + LANE) + 0.5f, y = (float)py + 0.5f;
  float16 across = fma(x, (float16)(camera->ray[0]), (float16)(camera->ray[1]));
  float16 up = fma(y, (float16)(camera->ray[2]), (float16)(camera->ray[3]));
  if (camera->parallel) {
    across = fma(distance, (float16)(camera->slant[0]), across);
    up = fma(distance, (float16)(camera->slant[1]), up);
  } else {
    across *= distance;
    up *= distance;
  }
  global const ChannelConstants* channels = s->channels;
  EyeVector world;
  world.x = row_times_point(channels->eye_to_world[0], across, up, -distance);
  world.y = row_times_point(channels->eye_to_world[1], across, up, -distance);
  world.z = row_times_point(channels->eye_to_world[2], across, up, -distance);
  return world;
}

// x, y and w of clip space, from the records of `motion` from `first` on.
typedef struct {
  float16 x, y, w;
} Motion;
ALWAYS_INLINE Motion motion_at(const ChannelShader* s, const Places* places, size_t first) {
  int16 x[3], y[3], w[3], unused;
  FOR_THREE(i) fetch(s->motion + first, places->vertex[i], places->same, &x[i], &y[i], &w[i], &unused);
  Motion motion;
  motion.x = shared(places, as_float16(x[0]), as_float16(x[1]), as_float16(x[2]));
  motion.y = shared(places, as_float16(y[0]), as_float16(y[1]), as_float16(y[2]));
  motion.w = shared(places, as_float16(w[0]), as_float16(w[1]), as_float16(w[2]));
  return motion;
}

// 0 where the place is behind the next eye, or a number is too large.
ALWAYS_INLINE void find_velocity(const ChannelShader* s, const Places* places, float16* u, float16* v) {
  const Motion now = motion_at(s, places, 0), next = motion_at(s, places, s->vertex_count);
  *u = (next.x / next.w - now.x / now.w) * ((float)s->shader.frame->width * 0.5f);
  *v = (next.y / next.w - now.y / now.w) * ((float)s->shader.frame->height * 0.5f);
  const int16 counts = (next.w > 0.0f) & (fabs(*u) <= MAXFLOAT) & (fabs(*v) <= MAXFLOAT);
  *u = select((float16)0.0f, *u, counts);
  *v = select((float16)0.0f, *v, counts);
}

ALWAYS_INLINE void find_uv(const ChannelShader* s, global const DrawConstants* draw, uint uvs, const Places* places,
                           float16* u, float16* v) {
  float us[3][LANES], vs[3][LANES];
  FOR_THREE(i) for (int lane = 0; lane < LANES; lane++) {
    const uint at = uvs + places->vertex[i][places->same ? 0 : lane] - draw->first_vertex_group * LANES;
    us[i][lane] = s->mesh_data[at];
    vs[i][lane] = s->mesh_data[at + draw->pitch];
  }
  *u = shared(places, vload16(0, us[0]), vload16(0, us[1]), vload16(0, us[2]));
  *v = shared(places, vload16(0, vs[0]), vload16(0, vs[1]), vload16(0, vs[2]));
}

ALWAYS_INLINE Rgb find_albedo(const ChannelShader* s, global const DrawConstants* draw, global const ChannelDraw* own,
                              const Places* places) {
  Rgb albedo;
  albedo.r = own->albedo[0];
  albedo.g = own->albedo[1];
  albedo.b = own->albedo[2];
  if (!(draw->flags & DRAW_VERTEX_COLORS)) return albedo;
  int16 r[3], g[3], b[3], unused;
  FOR_THREE(i) fetch(s->shader.colors, places->vertex[i], places->same, &r[i], &g[i], &b[i], &unused);
  albedo.r *= shared(places, as_float16(r[0]), as_float16(r[1]), as_float16(r[2]));
  albedo.g *= shared(places, as_float16(g[0]), as_float16(g[1]), as_float16(g[2]));
  albedo.b *= shared(places, as_float16(b[0]), as_float16(b[1]), as_float16(b[2]));
  return albedo;
}

// ---- all of them ----------------------------------------------------------------------------------------------------

#define CHANNELS_OF_PLACES (1u << CHANNEL_NORMAL | 1u << CHANNEL_POSITION | 1u << CHANNEL_VELOCITY | 1u << CHANNEL_UV)

// The ids (the first alone when `same`) all belong to draw `number`; the lanes `here` are set.
ALWAYS_INLINE void show_draw(const ChannelShader* s, uint number, Lanes id, bool same, int x, int y, int16 here,
                             Centres* centres) {
  global const DrawConstants* draw = &s->shader.draws[number];
  global const ChannelDraw* own = &s->draws[number];
  centres->object_id = select(centres->object_id, (uint16)(own->object_id), as_uint16(here));
  centres->material_id = select(centres->material_id, (uint16)(own->material_id), as_uint16(here));
  Places places;
  if (s->channels->channels & CHANNELS_OF_PLACES || (makes(s, CHANNEL_ALBEDO) && draw->flags & DRAW_VERTEX_COLORS))
    find_places(s, draw, id, same, x, y, &places);
  if (makes(s, CHANNEL_ALBEDO)) {
    const Rgb albedo = find_albedo(s, draw, own, &places);
    centres->albedo.r = select(centres->albedo.r, albedo.r, here);
    centres->albedo.g = select(centres->albedo.g, albedo.g, here);
    centres->albedo.b = select(centres->albedo.b, albedo.b, here);
  }
  if (makes(s, CHANNEL_NORMAL) && draw->flags & (DRAW_VERTEX_NORMALS | DRAW_FACE_NORMALS)) {
    const EyeVector normal = world_normal(s, draw, &places);
    centres->normal.x = select(centres->normal.x, normal.x, here);
    centres->normal.y = select(centres->normal.y, normal.y, here);
    centres->normal.z = select(centres->normal.z, normal.z, here);
  }
  if (makes(s, CHANNEL_POSITION)) {
    const EyeVector position = world_position(s, places.distance, x, y);
    centres->position.x = select(centres->position.x, position.x, here);
    centres->position.y = select(centres->position.y, position.y, here);
    centres->position.z = select(centres->position.z, position.z, here);
  }
  if (makes(s, CHANNEL_VELOCITY) && own->moves) {
    float16 u, v;
    find_velocity(s, &places, &u, &v);
    centres->velocity_u = select(centres->velocity_u, u, here);
    centres->velocity_v = select(centres->velocity_v, v, here);
  }
  if (makes(s, CHANNEL_UV) && own->uvs != NO_ID) {
    float16 u, v;
    find_uv(s, draw, own->uvs, &places, &u, &v);
    centres->u = select(centres->u, u, here);
    centres->v = select(centres->v, v, here);
  }
}

// What the centres of 16 pixels show whose ids are `ids`; one draw after the other.
ALWAYS_INLINE Centres centres_of(const ChannelShader* s, uint16 ids, int x, int y) {
  Centres centres = no_centres();
  const Lanes id = lanes_of(ids);
  int16 waiting = ids != NO_ID;
  if (!any_lane(waiting)) return centres;
  if (!any_lane(ids != id.lane[0])) {
    show_draw(s, s->shader.draw_of_group[id.lane[0] / (PIECES * LANES)], id, true, x, y, waiting, &centres);
    return centres;
  }
  while (any_lane(waiting)) {
    const uint first_id = id.lane[first_lane(waiting)];
    const uint number = s->shader.draw_of_group[first_id / (PIECES * LANES)];
    global const DrawConstants* draw = &s->shader.draws[number];
    const uint low = draw->first_primitive_group * (PIECES * LANES),
               high = low + (draw->primitive_group_count * (PIECES * LANES) - 1);
    const int16 here = waiting & (ids >= low) & (ids <= high);
    show_draw(s, number, lanes_of(select((uint16)(first_id), ids, as_uint16(here))), false, x, y, here, &centres);
    waiting &= ~here;
  }
  return centres;
}

#endif
