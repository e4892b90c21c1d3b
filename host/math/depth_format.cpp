#include "morphcl/depth_format.hpp"

#include <cmath>

namespace morphcl {

namespace {

constexpr std::array<std::string_view, 5> names = {"reversed_float", "float", "fixed16", "fixed24", "fixed32"};

// Differences of the distances come before products: both planes are met exactly, and nothing cancels twice.
double normalized_depth(const DepthRange& range, double distance) {
  if (range.parallel) return (range.far - distance) / (range.far - range.near);
  if (std::isinf(range.far)) return range.near / distance;
  return range.near / distance * ((range.far - distance) / (range.far - range.near));
}

// 1 - normalized depth, as exact next to the near plane as that is next to the far one. Both halves are monotone in
// fp64 (the difference is exact up to 2 near) and meet in 1/2.
double forward_depth(const DepthRange& range, double distance) {
  if (range.parallel) return (distance - range.near) / (range.far - range.near);
  const double from_near = distance < 2 * range.near ? (distance - range.near) / distance : 1 - range.near / distance;
  return std::isinf(range.far) ? from_near : from_near * (range.far / (range.far - range.near));
}

double distance_at(const DepthRange& range, double normalized_depth) {
  if (range.parallel) return range.far - normalized_depth * (range.far - range.near);
  const double ratio = range.near / range.far;  // 0 where far is infinite
  return range.near / (ratio + normalized_depth * (1 - ratio));
}

}  // namespace

std::string_view name_of(DepthFormat format) { return names[static_cast<std::size_t>(format)]; }

std::optional<DepthFormat> depth_format_named(std::string_view name) {
  for (const DepthFormat format : depth_formats)
    if (name_of(format) == name) return format;
  return std::nullopt;
}

double steps_of(DepthFormat format) {
  switch (format) {
    case DepthFormat::fixed16:
      return 0x1p16 - 1;
    case DepthFormat::fixed24:
      return 0x1p24 - 1;
    case DepthFormat::fixed32:
      return 0x1p32 - 1;
    case DepthFormat::reversed_float:
    case DepthFormat::forward_float:
      break;
  }
  return 0;
}

double stored_depth(DepthFormat format, const DepthRange& range, double distance) {
  if (format == DepthFormat::reversed_float)
    return static_cast<float>(range.parallel ? -distance : range.near / distance);
  if (format == DepthFormat::forward_float) return static_cast<float>(forward_depth(range, distance));
  return std::nearbyint(normalized_depth(range, distance) * steps_of(format));
}

double distance_of_stored(DepthFormat format, const DepthRange& range, double stored) {
  if (format == DepthFormat::reversed_float) return range.parallel ? -stored : range.near / stored;
  return distance_at(range, format == DepthFormat::forward_float ? 1 - stored : stored / steps_of(format));
}

}  // namespace morphcl
