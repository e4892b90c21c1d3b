// What host and kernels share: the structs in buffers and the constants of the raster design. Included by the kernels and,
// through host/render/frame/kernel_layout.hpp, by the host, which checks the sizes.
//
// Names: a *vertex* is one record after projection; a *group* is 16 vertices of one draw; a *block* is 16 primitives of one
// draw; a *chunk* is a run of groups or blocks that one work-item walks through; a *tile* is 64 x 64 pixels.
// Blocks are numbered in drawing order and binned draw by draw from near to far: a block's place in that order is its
// *position*. A primitive's number counts through all blocks of the frame: block * 16 + lane. An *id* is number * 8 + piece, piece 0
// for a primitive drawn as it is and 1 to 7 for the triangles that clipping cut it into, so ids compare in drawing order.

#ifndef MORPHCL_LAYOUT_H
#define MORPHCL_LAYOUT_H

#define LANES 16
#define TILE 64               // pixels; also 64 x 64 = 4096 samples in a tile
#define TILE_BLOCK 16         // pixels; a tile has 4 x 4 of them
#define SUBPIXEL_BITS 8       // vertices are snapped to 1/256 pixel
#define SMALL_PIXELS 8        // a triangle over at most 8 x 8 pixel centres is rasterised while it is binned
#define PAGE 64               // entries a page of the bins
#define ENTIRE_TILE 0x80000000u  // in an entry: the triangle covers all of the tile
#define CLIP_VERTICES 8       // a triangle clipped by five planes has at most 8 corners
#define GROUPS_PER_CHUNK 64   // vertex groups a work-item transforms

#define NO_ID 0xffffffffu     // a sample that nothing covers
#define OUTSIDE ((int)0x80000000)  // in place of x: the vertex needs clipping, y holds its outcode
#define BACKGROUND_DEPTH 1e10f
#define LARGEST_CLIP 1e33f    // clip coordinates beyond this are invalid: guard factor times w must not overflow

// Depth buffers, as in host/math/depth_format.hpp. A program is compiled for one of them.
#define DEPTH_REVERSED_FLOAT 0
#define DEPTH_FLOAT 1
#define DEPTH_FIXED_16 2
#define DEPTH_FIXED_24 3
#define DEPTH_FIXED_32 4
#ifndef DEPTH_FORMAT
#define DEPTH_FORMAT DEPTH_REVERSED_FLOAT
#endif

// Outcode bits: outside the near plane or a side of the guard band, or not finite.
#define OUT_NEAR 1
#define OUT_LEFT 2
#define OUT_RIGHT 4
#define OUT_TOP 8
#define OUT_BOTTOM 16
#define OUT_INVALID 32

// Draw flags.
#define DRAW_LINES 1u          // primitives are line segments
#define DRAW_DOUBLE_SIDED 2u   // back faces are drawn, their normals turned round
#define DRAW_MIRRORED 4u       // front faces turn clockwise in object space
#define DRAW_SMOOTH 8u         // normals are interpolated and lit per pixel
#define DRAW_FLAT 16u          // one irradiance a face
#define DRAW_VERTEX_COLORS 32u
#define DRAW_PIVOT 64u         // vertices are computed relative to a pivot, which the matrices have taken in
#define DRAW_TWO_FLOAT 128u    // vertices are computed in two floats

typedef struct {
  float object_to_clip[4][4];  // rows x, y, depth, w; entry 3 is the constant
  float object_to_eye[3][4];
  float normal_to_eye[3][4];   // entry 3 unused
  float base_color[4];
  uint flags;
  uint first_group;      // of this draw's vertices; vertex i is record first_group * 16 + i
  uint group_count;
  uint first_block, block_count;  // lane l of block b is primitive (b - first_block) * 16 + l of the mesh
  uint first_position;   // of its blocks in the order in which they are binned
  uint positions;        // float index of x in the mesh data; y and z follow at distance `pitch`
  uint normals;
  uint colors;           // r, g, b, a planes
  uint pitch;            // floats, a multiple of 16
  uint indices;          // uint index of the first corners in the index data; second and third at distance index_pitch
  uint index_pitch;
  uint first_target;     // into the table of active targets
  uint target_count;
  uint precise;          // into the table of draws with DRAW_PIVOT or DRAW_TWO_FLOAT
} DrawConstants;

typedef struct {
  float pivot[4];
  float clip_rest[4][4];  // what rounding took from object_to_clip
} PreciseConstants;

typedef struct {
  float weight;       // of the target
  float base_weight;  // of the base
  uint positions;     // float index in the mesh data, or NO_ID: does not move them
  uint normals;
  uint colors;
  float weight_rest;  // what rounding took from the weight; of draws with DRAW_TWO_FLOAT
  uint pad[2];
} TargetConstants;

typedef struct {
  float vector[4];  // eye space: unit direction towards the light, or position
  float color[4];
  uint is_point;
  uint falloff;
  uint pad[2];
} LightConstants;

typedef struct {
  float ambient[4];
  float scale_x, offset_x, scale_y, offset_y;  // sub-pixel = ndc * scale + offset
  float guard_x, guard_y;                      // clip against |x| <= guard * w
  float near_plane[4];                         // distance in front of it: [0] z + [1] w + [2]; entry 3 unused
  float near_w, near_depth;                    // w and depth = z / w on the near plane
  float far_depth;                             // smaller depths are not drawn
  float near;                                  // perspective: distance = near / depth; parallel: -depth
  // Of forward depth buffers: the depth of the far plane and the factor of closeness, each as two floats; 1 / factor.
  float depth_far[2], depth_scale[2], depth_span;
  float ray[4];                                // eye position of a pixel: FramePlan::ray and slant
  float slant[2];
  int width, height;
  int tiles_x, tiles_y;
  uint row_bytes;          // from one row of the picture to the next
  uint color_offset[4], depth_offset;  // bytes from the start of a row to R, G, B, A and to the distances in it
  uint tile_step;          // tiles are walked in steps of this, coprime to their number, to spread the load
  uint parallel;
  uint light_count, has_point_lights;
  uint group_count, block_count;
  uint chunk_count, blocks_per_chunk;
  uint clip_capacity;      // clipped primitives that fit
  uint first_clip_vertex;  // record index where clipped corners start
  uint fragment_pages, entry_pages, large_capacity;  // of one chunk
  uint writes_color, writes_depth;
  uint clips;              // 0: the plan proved that nothing needs clipping
  uint only_faces;         // every draw is flat and without vertex colours
  uint divides;            // 0: w is 1 everywhere
  uint tests_depth;        // 0: the plan proved that no pixel centre is covered twice
  uint keeps_blank_tiles;  // blocks of the picture that are marked as background and stay it are not written
} FrameConstants;

// What a chunk found out while binning, for the host: pools that were too small are grown and the frame is binned again.
typedef struct {
  uint clipped, fragment_pages, entry_pages, large;
} ChunkStatus;

// How depth runs over a triangle a b c: kernels/reversed_depth.h and kernels/forward_depth.h.
#if DEPTH_FORMAT == DEPTH_REVERSED_FLOAT
typedef struct {
  float depth;       // at a, the farthest corner
  float depth1;      // at b minus at a
  float depth2;      // at c minus at a
  float inverse_area;
  float depth_dx, depth_dy;  // per pixel
  uint pad[3];
} DepthPlane;
#else
typedef struct {
  float a[2], b[2], c[2];  // closeness of the corners over the doubled area, each as two floats
  uint least, greatest;    // of the corners' keys
  uint in_range;           // no part is beyond the far plane
} DepthPlane;
#endif

// A triangle that is rasterised in the tiles.
typedef struct {
  int ax, ay;        // sub-pixels
  int d1x, d1y;      // b - a
  int d2x, d2y;      // c - a
  uint id;
  DepthPlane plane;
} LargeTriangle;

#endif
