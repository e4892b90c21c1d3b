#pragma OPENCL FP_CONTRACT OFF
// The kernels of bin_primitives.cl for pictures of several samples a pixel (-DSAMPLES=N). Fragments have a bit for each
// sample of their pixel.
//
// bin_samples                  the bins of one chunk of primitive groups
// light_and_bin_samples        the same after the light of the chunk's faces
// project_light_and_bin_samples   all of a frame that is no more than one chunk of vertices and one of primitives, of
//                              which nothing is clipped

#ifndef SAMPLES
#define SAMPLES 4  // for who reads this file alone
#endif

#include "bin_primitives.h"
#include "light_faces.h"
#include "project_vertices.h"

kernel void bin_samples(global const FrameConstants* frame, global const DrawConstants* draws,
                        global const uint* indices, global const int4* vertices, global const ClippedPrimitive* clipped,
                        global SampleFragment* sample_fragments, global BinsHeader* bins, global LargeTriangle* large) {
  bin_chunk((uint)get_global_id(0), frame, draws, indices, vertices, clipped, (global Fragment*)sample_fragments, bins,
            large);
}

kernel void light_and_bin_samples(global const FrameConstants* frame, global const DrawConstants* draws,
                                  global const uint* indices, global const int4* vertices,
                                  global const int4* attributes, global int4* face_colors,
                                  global const ClippedPrimitive* clipped, global SampleFragment* sample_fragments,
                                  global BinsHeader* bins, global LargeTriangle* large) {
  light_chunk((uint)get_global_id(0), frame, draws, indices, attributes, face_colors);
  bin_chunk((uint)get_global_id(0), frame, draws, indices, vertices, clipped, (global Fragment*)sample_fragments, bins,
            large);
}

kernel void project_light_and_bin_samples(global const FrameConstants* frame, global const DrawConstants* draws,
                                          global const TargetConstants* targets, global const float* mesh_data,
                                          global const uint* indices, global int4* vertices, global int4* attributes,
                                          global int4* colors, global int4* face_colors,
                                          global SampleFragment* sample_fragments, global BinsHeader* bins,
                                          global LargeTriangle* large) {
  project_chunk(0, frame, draws, targets, mesh_data, vertices, attributes, colors, bins);
  light_chunk(0, frame, draws, indices, attributes, face_colors);
  bin_chunk(0, frame, draws, indices, vertices, 0, (global Fragment*)sample_fragments, bins, large);
}
