// The depth buffer that a program is compiled for: -DDEPTH_FORMAT=N, N as in host/math/depth_format.hpp. Programs for
// the default hold nothing of the others.

#ifndef MORPHCL_DEPTH_FORMAT_H
#define MORPHCL_DEPTH_FORMAT_H

#include "raster.h"
#include "two_float.h"

#if DEPTH_FORMAT == DEPTH_REVERSED_FLOAT
#include "reversed_depth.h"
#else
#define FORWARD_DEPTH
#include "forward_depth.h"
#endif

#endif
