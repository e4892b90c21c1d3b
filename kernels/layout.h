// What host and kernels share: the structs in buffers and the constants of the raster design. Included by the kernels
// and, through host/render/frame/kernel_layout.hpp, by the host, which checks the sizes.
//
// The picture. Tiles are numbered row by row, blocks within a tile likewise; y points downwards:
//
//     tile of 64 x 64 pixels        block of 16 x 16 pixels       pixel
//     +----+----+----+----+         +----------------+            +-----------------+
//     |  0 |  1 |  2 |  3 |         | row: 16 pixels |            | 256 x 256       |
//     +----+----+----+----+         | = one vector,  |            | sub-pixels;     |
//     |  4 |  5 |  6 |  7 |         | one pixel a    |            | its centre is   |
//     +----+----+----+----+         | lane           |            | at (128, 128)   |
//     |  8 |  9 | 10 | 11 |         |                |            |                 |
//     +----+----+----+----+         |                |            |                 |
//     | 12 | 13 | 14 | 15 |         |                |            |                 |
//     +----+----+----+----+         +----------------+            +-----------------+
//
// The order of things. Vertices and primitives of all draws follow each other, each draw's padded to groups of 16:
//
//     vertex group      |--- draw 0 ---|- draw 1 -|---- draw 2 ----|    vertex i: record first_vertex_group * 16 + i
//     primitive group   |- draw 0 -|--- draw 1 ---|- draw 2 -|          id = (group * 16 + lane) * 8 + piece
//     order of binning  |- draw 2 -|- draw 0 -|--- draw 1 ---|          the same primitive groups, near draws first
//     chunk             |=====0=====|=====1=====|====2====|             a run of groups, one work-item walks it
//
// An id has piece 0 for a primitive drawn as it is and 1 to 7 for the triangles that clipping cut it into, so that ids
// compare in drawing order.
//
// The bins of a chunk: for each tile a list of pages of 64 entries, filled one after the other; page 0 is "none".
//
//     heads[tile] ---> behind the newest entry of page 7      next[7] = 3, next[3] = 0: page 3 was filled before page 7
//
//     page  0          3                     7
//           (none) ... [eeeeeeeeeeeeeeee] .. [eeeee...........]

#ifndef MORPHCL_LAYOUT_H
#define MORPHCL_LAYOUT_H

#include "camera.h"
#include "sample_pattern.h"

#define LANES 16  // of a vector; vertices or primitives in a group
#define TILE_BITS 6
#define TILE (1 << TILE_BITS)            // pixels
#define TILE_BLOCK 16                    // pixels
#define TILE_BLOCKS (TILE / TILE_BLOCK)  // in a row and in a column
#define SUBPIXEL_BITS 8                  // vertices are snapped to 1/256 pixel
#define SUBPIXELS (1 << SUBPIXEL_BITS)
#define HALF_PIXEL (SUBPIXELS / 2)
#define MAX_SUBPIXEL 8388604.0f          // snapped coordinates within the guard band are at most this: 2^23 - 4
#define CORNER_BITS 7                    // vertex records have corners in corner units, 1/128 sub-pixel: coverage takes
#define CORNER_UNITS (1 << CORNER_BITS)  // the nearest sub-pixel, planes go through where they are
#define MAX_GUARD 4096.0f                // of the guard band's factor, so that tiny images do not overflow w
#define SMALL_PIXELS 8                   // a triangle over at most 8 x 8 pixel centres is rasterised while it is binned
#define PAGE 64                          // entries a page of the bins
#define ENTIRE_TILE 0x80000000u          // in an entry: the triangle covers all of the tile
#define CLIP_VERTICES 8                  // corners at most of a triangle that all planes cut
#define PIECE_BITS 3                     // of an id: a primitive as it is, or a piece of what clipping left
#define PIECES (1 << PIECE_BITS)
#define VERTEX_GROUPS_PER_CHUNK 64

#define LAYER_PLANES(samples) ((samples) <= 2 ? 32 : 64 / (samples))  // blended surfaces that one pass sorts

#define NO_ID 0xffffffffu          // a sample that nothing covers
#define OUTSIDE ((int)0x80000000)  // in place of x: the vertex needs clipping, y holds its outcode
#define BACKGROUND_DEPTH 1e10f
#define MAX_CLIP_COORDINATE 1e33f   // what is beyond is invalid: guard factor times w must not overflow
#define MIN_NORMAL_SQUARE 0x1p-20f  // a morphed normal shorter than 2^-10 has been cancelled: the base's is taken

// Depth buffers, as in include/morphcl/depth_format.hpp. A program is compiled for one of them.
#define DEPTH_REVERSED_FLOAT 0
#define DEPTH_FLOAT 1
#define DEPTH_FIXED_16 2
#define DEPTH_FIXED_24 3
#define DEPTH_FIXED_32 4
#ifndef DEPTH_FORMAT
#define DEPTH_FORMAT DEPTH_REVERSED_FLOAT
#endif
#define MAX_NORMALIZED_DEPTH 0x1p60f  // triangles that reach farther beyond the far plane are bent

// The planes that primitives are clipped by, in this order.
#define NEAR_PLANE 0
#define LEFT_PLANE 1
#define RIGHT_PLANE 2
#define BOTTOM_PLANE 3
#define TOP_PLANE 4
#define CLIP_PLANES 5

// Outcode bits: outside the near plane or a side of the guard band, or not finite.
#define OUT_NEAR 1
#define OUT_LEFT 2
#define OUT_RIGHT 4
#define OUT_TOP 8
#define OUT_BOTTOM 16
#define OUT_INVALID 32

// Draw flags.
#define DRAW_LINES 1u         // primitives are line segments
#define DRAW_DOUBLE_SIDED 2u  // back faces are drawn, their normals turned round
#define DRAW_MIRRORED 4u      // front faces turn clockwise in object space
#define DRAW_SMOOTH 8u        // normals are interpolated and lit per pixel
#define DRAW_FLAT 16u         // one colour a face, or one normal
#define DRAW_VERTEX_COLORS 32u
#define DRAW_PIVOT 64u           // vertices are computed relative to a pivot, which the matrices have taken in
#define DRAW_TWO_FLOAT 128u      // vertices are computed in two floats
#define DRAW_LIT_PER_PIXEL 256u  // of a flat draw: face_colors holds its faces' normals, which are lit per pixel
#define DRAW_BLENDED 512u        // what lies behind shows through: it goes into lists of its own
// Channel N takes the vertices' normals, or those of the faces; of lines neither.
#define DRAW_VERTEX_NORMALS 4096u
#define DRAW_FACE_NORMALS 8192u

// ---- buffers --------------------------------------------------------------------------------------------------------
//
// A kernel takes at most 12 buffers; small tables share one, told apart by offsets in FrameConstants. Sharing lowers no
// limit, though a device may allocate no more than a quarter of its memory at once:
//
//   frame          constants, lights, numbers of changed vertex chunks, precise constants, halves R, G, B, A of the
//                  background for each row; for other channels 48 bytes a draw, and for velocity the draws of the next
//                  frame, 320 each. At most 448 bytes a draw, 8 a row of the picture and 4 a chunk of 64 vertex groups,
//                  while a draw has at least 256 bytes of vertices, and for velocity 512 more. (Lights are read for
//                  every pixel: time ends them, not memory.)
//   draws          constants and the draws of vertex groups, of primitive groups and in the order of binning: 244 a
//                  draw, 4 a vertex group, 8 a primitive group. Vertices take 256 a vertex group, fragment keys at
//                  least 256 a primitive group: one of them is the larger.
//   clipped        source and weights: 104 bytes a primitive, whose corners take 128 of the vertices.
//   bins           all of the bins but the fragments' keys and the large triangles. Lists of the tiles take 268 bytes a
//                  tile and chunk, the rest a quarter of the keys. Where that is too much, there are fewer chunks: of
//                  one chunk the lists take a hundredth of the picture (host/render/frame/bin_pools.cpp). Tables of
//                  ids take 64 MB at most (channel_layout.h).
//   fragment_keys or sample_fragments, large, vertices, attributes, colors, face_colors, indices, mesh_data, targets:
//   each on its own, since any of them can be the largest.

typedef struct {
  float object_to_clip[4][4];  // rows x, y, depth, w; entry 3 is the constant
  float object_to_eye[3][4];
  float normal_to_eye[3][4];  // entry 3 unused
  float base_color[4];
  uint flags;
  uint first_vertex_group;  // of this draw's vertices; vertex i is record first_vertex_group * 16 + i
  uint vertex_group_count;
  uint first_primitive_group, primitive_group_count;
  uint first_in_order;  // of its primitive groups in the order of binning
  uint positions;       // float index of x in the mesh data; y and z follow at distance `pitch`
  uint normals;
  uint colors;   // r, g, b, a planes
  uint pitch;    // floats, a multiple of 16
  uint indices;  // uint index of the first corners in the index data; second and third at distance index_pitch
  uint index_pitch;
  uint first_target;  // into the table of active targets
  uint target_count;
  uint precise;        // into the table of draws with DRAW_PIVOT or DRAW_TWO_FLOAT
  uint line_width;     // sub-pixels
  float alpha_cutoff;  // of a blended draw: alpha is 1 from here on, below it 0. Negative: it stays what it is
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
  uint has_cone;  // a spot light: what follows says how the light's share falls from the beam to the cone's edge
  float cone_scale;
  float beam[3];  // unit vector in eye space, away from the light
  float cone_offset;
} LightConstants;

// A primitive that clipping cut; its corners are vertex records from first_clip_vertex + 8 * slot on.
typedef struct {
  uint source;                      // number of the primitive
  uint count;                       // corners: 2 of a line, 3 to 8 of a polygon, 0 of nothing
  float weights[CLIP_VERTICES][3];  // of each corner at the source triangle's vertices
} ClippedPrimitive;

// What a chunk found out while binning, for the host: pools that were too small are grown and the frame is binned
// again.
typedef struct {
  uint clipped, fragment_pages, entry_pages, large;
} ChunkStatus;

// Of pixels with several samples: what a small triangle or a line leaves at one pixel. Depth is a plane there; where it
// is stored as a key, each sample has a fragment of its own, without slopes.
typedef struct {
  uint depth, id;            // bits of the depth at the pixel's centre
  float depth_dx, depth_dy;  // per pixel
  uint place_and_mask;  // of the pixel in the tile: block << 8 | row << 4 | column; above, bit s: sample s is covered
} SampleFragment;
#define PLACE_IN_TILE_BITS 12

// What the buffer of the bins begins with.
typedef struct {
  uint overflow;  // not 0: some pool was too small
  uint pad[15];
} BinsHeader;

// Where the tables in `bins` begin, in bytes.
typedef struct {
  ulong chunk_status;                                 // ChunkStatus of each chunk
  ulong vertex_chunk_status;                          // uint of each chunk of vertices: not 0 when some need clipping
  ulong fragment_heads;                               // uint[chunk][tile]
  ulong entry_heads;                                  // uint[chunk][tile]
  ulong blended_fragment_heads, blended_entry_heads;  // the same, of blended draws
  ulong fragment_next;                                // uint[chunk][page]
  ulong entry_next;                                   // uint[chunk][page]
  ulong entry_triangles;  // uint[chunk][page][entry]: index of a large triangle, perhaps with ENTIRE_TILE
  ulong fragment_places;  // ushort[chunk][page][entry]: row << TILE_BITS | column in the tile
  ulong ids;              // TileIds and ids of each tile of a band
} BinsOffsets;

typedef struct {
  BinsOffsets bins;
  CameraConstants camera;
  float ambient[3];
  float scale_x, offset_x, scale_y, offset_y;  // sub-pixel = ndc * scale + offset
  float guard_x, guard_y;                      // clip against |x| <= guard * w
  int width, height;
  int tiles_x, tiles_y;
  uint row_bytes;                                    // from one row of the picture to the next
  uint color_offset[4], depth_offset, notes_offset;  // bytes from the start of a row to R, G, B, A, distances, notes
  uint tile_step;  // tiles are walked in steps of this, coprime to their number in each launch, to spread the load
  uint light_count, has_point_lights;
  uint vertex_group_count, primitive_group_count;
  uint chunk_count, primitive_groups_per_chunk;
  uint clip_capacity;                                // clipped primitives that fit
  uint first_clip_vertex;                            // record index where clipped corners start
  uint fragment_pages, entry_pages, large_capacity;  // of one chunk
  uint writes_color, writes_depth;
  uint clips;              // 0: the plan proved that nothing needs clipping
  uint only_faces;         // every draw is flat, lit at its centre, and without vertex colours
  uint divides;            // 0: w is 1 everywhere
  uint tests_depth;        // 0: the plan proved that no pixel centre is covered twice
  uint has_background;     // 0: colour and alpha are 0 where nothing is drawn
  uint keeps_blank_tiles;  // blocks of the picture that are marked as background and stay it are not written
  uint first_of_two;       // of two passes over the picture, colour and distances: notes keep both kinds of marks
  uint second_of_two;
  uint blends;  // some draw is blended: bins have lists of such draws beside the others
  // Where the tables in `frame` and `draws` begin, in words of 4 bytes.
  uint lights, changed_vertex_chunks, precise, background;
  uint draw_of_vertex_group, draw_of_primitive_group, draw_in_order;
  uint channels;    // the table of ChannelConstants
  uint writes_ids;  // tiles leave tables of ids, for shade_channels
  uint pad;
} FrameConstants;

#include "channel_layout.h"

// How depth runs over a triangle a b c: kernels/reversed_depth.h and kernels/forward_depth.h.
#if DEPTH_FORMAT == DEPTH_REVERSED_FLOAT
typedef struct {
  float depth, nearest;      // at a, the farthest corner, and at the nearest one
  float depth_dx, depth_dy;  // per pixel
  int margin;                // margin_of_large() in whole pixel steps, as edges in tiles have it
  uint pad[4];
} DepthPlane;
#else
typedef struct {
  float a[2], b[2], c[2];  // normalized depth of the corners over the doubled area, each as two floats
  uint min_key, max_key;   // of the corners
  uint in_range;           // no part is beyond the far plane
} DepthPlane;
#endif

// A triangle that is rasterised in the tiles.
typedef struct {
  int x[3], y[3];  // corner units
  uint id;
  DepthPlane plane;
} LargeTriangle;

#endif
