// Which side of some planes of clip space a box lies on, judged carefully enough for the fp32 arithmetic of renderers.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace morphcl {

enum class Side { inside, touching, outside };

// All points within `half` of `center`, componentwise; `magnitude` bounds the terms whose sums its coordinates are.
struct BoundedBox {
  glm::dvec3 center, half, magnitude;
};

// Half-spaces of clip space, seen from the space that `to_clip` leads from.
//
// A box is inside or outside only when every point of it still is after rounding: renderers round the matrix to fp32 (1
// unit of 2^-24), apply it in 3 fma steps, and compare or divide in at most 6 more operations: 10 units of the sum of
// the terms' magnitudes, which `slack` bounds. Inside also promises clip coordinates below 1e33, so that no renderer
// takes them for invalid. Boxes with NaN or infinity are touching.
class HalfSpaces {
 public:
  HalfSpaces(std::span<const glm::dvec4> planes, const glm::dmat4& to_clip);
  // Outside: of one of them. Inside: of all.
  Side side(const BoundedBox& box) const {
    Side result = Side::inside;
    for (int i = 0; i < count_; ++i) {
      const Plane& p = planes_[i];
      const double middle = dot(p.normal, box.center) + p.offset, reach = dot(p.absolute, box.half);
      const double terms = dot(p.terms, box.magnitude) + p.offset_terms, margin = slack * terms;
      if (middle + reach < -margin) return Side::outside;
      if (!(middle - reach > margin && terms < max_terms)) result = Side::touching;
    }
    return result;
  }

 private:
  static constexpr double slack = 1e-6;  // > 10 * 2^-24
  static constexpr double max_terms = 1e33;
  static constexpr int max_planes = 6;
  struct Plane {
    glm::dvec3 normal, absolute, terms;  // absolute = |normal|; terms: without what cancels when rows are combined
    double offset, offset_terms;
  };
  static double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  Plane planes_[max_planes];
  int count_ = 0;
};

}  // namespace morphcl
