// The depth buffer that a program is compiled for: -DDEPTH_FORMAT=N, N as in include/morphcl/depth_format.hpp. Programs
// for the default hold nothing of the others.

#ifndef MORPHCL_DEPTH_FORMAT_H
#define MORPHCL_DEPTH_FORMAT_H

// What both include stands here, before the choice: the build puts a header in where it is included first.
#include "layout.h"
#include "raster.h"
#include "two_float.h"
#include "vector.h"

#if DEPTH_FORMAT == DEPTH_REVERSED_FLOAT
#include "reversed_depth.h"
#else
#define FORWARD_DEPTH
#include "forward_depth.h"
#endif

#endif
