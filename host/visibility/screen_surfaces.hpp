// What the hidden-surface algorithms work on: the triangles of a picture after projection, clipping and snapping.
//
// Which pixels a surface covers is decided in integers, at pixel centres, as rasterizers do. Depth is linear on the
// screen after projection, so every surface has a depth plane; larger is nearer. A depth buffer stores that depth with
// an error, of which `Surface::error` is a bound. Surfaces that are further apart than their errors together have one
// order, by planes as by stored depths; where they are closer, the algorithms ask StoredDepths.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace morphcl::visibility {

constexpr int subpixels = 256;  // of a pixel; centres lie at half of them

using SurfaceId = std::uint32_t;  // index into ScreenSurfaces, in drawing order
constexpr SurfaceId no_surface = ~SurfaceId{0};

// A linear function over pixel centres.
struct DepthPlane {
  double at_origin = 0, dx = 0, dy = 0;  // at the centre of pixel (0, 0); change a pixel

  double at(double x, double y) const { return dx * x + dy * y + at_origin; }
  friend DepthPlane operator-(const DepthPlane& a, const DepthPlane& b) {
    return {a.at_origin - b.at_origin, a.dx - b.dx, a.dy - b.dy};
  }
};

// Pixels from first to last, both included; empty where first > last.
struct PixelBox {
  int first_x, first_y, last_x, last_y;

  bool empty() const { return first_x > last_x || first_y > last_y; }
  bool meets(const PixelBox& other) const {
    return first_x <= other.last_x && other.first_x <= last_x && first_y <= other.last_y && other.first_y <= last_y;
  }
};
inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.first_x, b.first_x), std::max(a.first_y, b.first_y), std::min(a.last_x, b.last_x),
          std::min(a.last_y, b.last_y)};
}

struct Surface {
  std::array<glm::ivec2, 3> corner;  // sub-pixels, within 2^23; the doubled area is positive (y points down)
  DepthPlane depth;
  double error;             // |stored depth - depth| at every pixel that is covered
  double min, max;          // of stored depth
  PixelBox box;             // what it covers lies in here, within the picture
  bool blended = false;     // what lies behind it shows through
  bool cut_by_far = false;  // some of the pixels that it covers may lie beyond the far plane: ask StoredDepths
};

// What the depth buffer has to say about two surfaces, or one, at a pixel that they cover.
class StoredDepths {
 public:
  virtual ~StoredDepths() = default;

  // Not beyond the far plane.
  virtual bool shows(SurfaceId surface, int x, int y) const = 0;

  // A total order at every pixel. Of opaque surfaces of equal depth the one that is drawn first is in front, of blended
  // ones the one that is drawn last, and a blended one is in front of an opaque one.
  virtual bool is_in_front(SurfaceId a, SurfaceId b, int x, int y) const = 0;
};

struct ScreenSurfaces {
  int width = 0, height = 0;
  std::vector<Surface> surfaces;
  const StoredDepths* stored = nullptr;

  const Surface& operator[](SurfaceId id) const { return surfaces[id]; }
  SurfaceId count() const { return static_cast<SurfaceId>(surfaces.size()); }
};

// Columns from first up to, not including, end.
struct Span {
  int first, end;
  bool empty() const { return first >= end; }
};

// What the surface covers of a row of its box. Exact: pixel centres on an edge belong to the surface whose top or left
// edge it is.
Span covered_columns(const Surface& surface, int y);

// How a surface and a window of pixel centres lie, from columns x0 to x1 and rows y0 to y1: outside may be missed,
// never wrongly said; surrounding is exact.
enum class WindowRelation : std::uint8_t { outside, crossing, surrounding };
WindowRelation relation_to_window(const Surface& surface, const PixelBox& window);

// Whether the triangles of two surfaces have no inner point in common, by an edge of one of them. Then they share no
// pixel.
bool are_apart(const Surface& a, const Surface& b);

// Whether `front` is nearer than `back` by more than the errors at the four corners of the window, so in all of it.
bool hides_in_window(const Surface& front, const Surface& back, const PixelBox& window);

}  // namespace morphcl::visibility
