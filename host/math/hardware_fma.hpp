// Functions that are compiled twice: with the fused multiply-add of the processor, and for processors that have none.
//
// Both compute the same bits, as fma is correctly rounded either way; the first is several times as fast. The choice is
// made once, when the program is loaded. What such a function calls must be MORPHCL_INLINED to be compiled with it. It
// must not throw: GCC 12 ends the program where a caller in the same file, or unity source, should see the exception.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
#define MORPHCL_WITH_HARDWARE_FMA [[gnu::target_clones("default", "fma")]]
#define MORPHCL_INLINED [[gnu::always_inline]] inline
#else
#define MORPHCL_WITH_HARDWARE_FMA
#define MORPHCL_INLINED inline
#endif
