// Loops over the elements of a batch, with the processor's own fused multiply-add and 256-bit vectors where it has
// them: the same bits as without, as every operation is correctly rounded.
#pragma once

#include <cstddef>

namespace morphcl::accuracy {

// A loop has the body as a copy of its own: what that holds stays in registers, as no store of the loop can change it.
// NOLINTBEGIN(performance-unnecessary-value-param)
template <class Body>
void plain_loop(std::size_t count, Body body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

#if defined(__x86_64__) && defined(__GNUC__)
template <class Body>
__attribute__((target("avx2,fma"), flatten)) void vector_loop(std::size_t count, Body body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}

inline bool has_vectors() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#else
template <class Body>
void vector_loop(std::size_t count, Body body) {
  plain_loop(count, body);
}

inline bool has_vectors() { return false; }
#endif

// body(i) for each i < count, in any order.
template <class Body>
void for_each_element(std::size_t count, Body body) {
  if (has_vectors())
    vector_loop(count, body);
  else
    plain_loop(count, body);
}
// NOLINTEND(performance-unnecessary-value-param)

}  // namespace morphcl::accuracy
