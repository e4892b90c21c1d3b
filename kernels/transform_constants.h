// What the kernels of batch transforms are told beside their arrays.

#ifndef MORPHCL_TRANSFORM_CONSTANTS_H
#define MORPHCL_TRANSFORM_CONSTANTS_H

#include "transform_kind.h"

typedef struct {
  ulong count;       // vertices
  ulong run_length;  // vertices of a run, a multiple of 16
  uint runs;         // of one work-item
  uint kind;         // TRANSFORM_AFFINE, ...
  uint matrix_count;
  uint stream_stores;  // not 0: aligned results bypass the cache
} TransformConstants;

#endif
