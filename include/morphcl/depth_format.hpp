// What a depth buffer keeps of a distance: a number of few bits, by which it tells which of two surfaces is nearer.
//
// The normalized depth of a distance is 1 on the near plane and 0 on the far one. With n = near, f = far, d = distance:
//   perspective  (n / d - n / f) / (1 - n / f)        parallel  (f - d) / (f - n)
// so the depth of the textbooks, 0 at near and 1 at far, is 1 - normalized depth.
//
//   reversed_float  n / d (perspective) or -d (parallel), rounded to binary32: no far plane takes part
//   forward_float   1 - normalized depth, rounded to binary32
//   fixedN          normalized depth times 2^N - 1, rounded to a whole number: steps counted from the far plane
#pragma once

#include <array>
#include <optional>
#include <string_view>

#pragma GCC visibility push(default)
namespace morphcl {

enum class DepthFormat { reversed_float, forward_float, fixed16, fixed24, fixed32 };
constexpr std::array<DepthFormat, 5> depth_formats = {DepthFormat::reversed_float, DepthFormat::forward_float,
                                                      DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::fixed32};

// "reversed_float", "float", "fixed16", "fixed24", "fixed32": the names of shot files and options.
std::string_view name_of(DepthFormat format);
std::optional<DepthFormat> depth_format_named(std::string_view name);

// Distances along the view axis that a camera sees. near > 0 unless parallel, far > near; far may be infinite in
// perspective.
struct DepthRange {
  double near, far;  // world units; not tested
  bool parallel = false;
};

// The number that a buffer of this format holds at a distance in [near, far]: a binary32 value or a whole number of
// steps. It is the formula's value rounded to nearest; within 2^-48, relative, of the middle between two numbers either
// may be given. A nearer distance is never stored as farther. Distances outside of [near, far] are not tested.
double stored_depth(DepthFormat format, const DepthRange& range, double distance);

// Whether the buffer takes one number for nearer than the other; equal numbers are a tie.
inline bool is_nearer(DepthFormat format, double stored, double other) {
  return format == DepthFormat::forward_float ? stored < other : stored > other;
}

// The distance that `stored` stands for, within 8u64 of that distance (perspective) or of the larger of it and
// far - near (parallel); infinity where `stored` is a far plane at infinity.
double distance_of_stored(DepthFormat format, const DepthRange& range, double stored);

// 2^N - 1 of a fixed format; 0 of the others.
double steps_of(DepthFormat format);

}  // namespace morphcl
#pragma GCC visibility pop
