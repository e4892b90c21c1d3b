// The camera of a frame as plain numbers, rounded to binary32 once: part of FramePlan, of what kernels are given and of
// what the digest of a plan covers. Every member is 4 bytes wide, so that equal cameras have equal bytes.

#ifndef MORPHCL_CAMERA_H
#define MORPHCL_CAMERA_H

typedef struct {
  float near_plane[3];               // distance in front of it: [0] depth row + [1] w row + [2]; 0 or more is drawn
  float near_w, near_depth;          // w and depth = z / w on the near plane; larger depths are nearer
  float far_depth;                   // on the far plane: smaller depths are not drawn
  float near;                        // perspective: distance = near / depth; parallel: -depth
  float depth_far[2];                // of forward depth buffers: the depth of the far plane as two floats,
  float depth_scale[2], depth_span;  // the factor of normalized depth as two floats, and 1 / factor
  // Eye position of a pixel for point lights, from its centre (x, y) and its distance d along the axis:
  // perspective: (x * ray[0] + ray[1]) * d, parallel: x * ray[0] + ray[1] + d * slant[0]; so on for y with ray[2],
  // ray[3] and slant[1]. The slant is how far a parallel projector leads sideways per unit of distance: 0 unless
  // oblique.
  float ray[4];
  float slant[2];
  int parallel;  // 1: parallel projectors, w is 1 everywhere
} CameraConstants;

#endif
