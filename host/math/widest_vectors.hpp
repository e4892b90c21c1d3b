// For a function whose loops compilers make vectors of: one more version of it for processors with AVX2, chosen when
// the program starts. The two compute the same.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MORPHCL_WIDEST_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define MORPHCL_WIDEST_VECTORS
#endif
