// Where the samples of a pixel lie: the standard patterns of Direct3D 11 and Vulkan, in 1/16 pixel from the pixel's
// centre, x to the right, y downwards. A program is compiled for one of them: -DSAMPLES=N.

#ifndef MORPHCL_SAMPLE_PATTERN_H
#define MORPHCL_SAMPLE_PATTERN_H

#ifndef SAMPLES
#define SAMPLES 1
#endif
#define MAX_SAMPLES 16
#define SAMPLE_UNIT_BITS 4  // 16 sub-pixels: 1/16 pixel

#define SAMPLES_1_X 0
#define SAMPLES_1_Y 0
#define SAMPLES_2_X 4, -4
#define SAMPLES_2_Y 4, -4
#define SAMPLES_4_X -2, 6, -6, 2
#define SAMPLES_4_Y -6, -2, 2, 6
#define SAMPLES_8_X 1, -1, 5, -3, -5, -7, 3, 7
#define SAMPLES_8_Y -3, 3, 1, -5, 5, -1, 7, -7
#define SAMPLES_16_X 1, -1, -3, 4, -5, 2, 5, 3, -2, 0, -4, -6, -8, 7, 6, -7
#define SAMPLES_16_Y 1, -3, 2, -1, -2, 5, 3, -5, 6, -7, -6, 4, 0, -4, 7, -8

// Those that the program is compiled for.
#if SAMPLES == 16
#define SAMPLES_X SAMPLES_16_X
#define SAMPLES_Y SAMPLES_16_Y
#elif SAMPLES == 8
#define SAMPLES_X SAMPLES_8_X
#define SAMPLES_Y SAMPLES_8_Y
#elif SAMPLES == 4
#define SAMPLES_X SAMPLES_4_X
#define SAMPLES_Y SAMPLES_4_Y
#elif SAMPLES == 2
#define SAMPLES_X SAMPLES_2_X
#define SAMPLES_Y SAMPLES_2_Y
#else
#define SAMPLES_X SAMPLES_1_X
#define SAMPLES_Y SAMPLES_1_Y
#endif

// The least and the greatest of them, along both axes alike.
#define MIN_SAMPLE(samples) ((samples) == 1 ? 0 : (samples) == 2 ? -4 : (samples) == 4 ? -6 : (samples) == 8 ? -7 : -8)
#define MAX_SAMPLE(samples) ((samples) == 1 ? 0 : (samples) == 2 ? 4 : (samples) == 4 ? 6 : 7)

#endif
