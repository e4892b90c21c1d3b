// Whether a point lies in a polygon: by the sum of the angles under which its edges are seen, or by winding.
//
// Planes: the point; constants of a batch: the corners of the polygon, all binary32. Results: 1 inside, 0 outside, and
// 1/2 on the boundary from those variants that know it; the others may say either there.
#include <cmath>
#include <glm/glm.hpp>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl::accuracy {

namespace {

constexpr std::size_t star_corners = 12;

struct StarCorner {
  double x, y;
};
using Star = std::array<StarCorner, star_corners>;

Star polygon_of(const Batch& batch) {
  Star polygon;
  for (std::size_t k = 0; k < star_corners; ++k) polygon[k] = {batch.constants[2 * k], batch.constants[2 * k + 1]};
  return polygon;
}

template <class Inside>
Variant<double> deciding(const char* name, Inside inside) {
  return {.name = name, .prepare = [inside](const Batch& batch) -> Variant<double>::Run {
            const double *x = batch.truth.plane(0), *y = batch.truth.plane(1);
            return [=, polygon = polygon_of(batch), count = batch.size()](Planes<double>& results) {
              for (std::size_t i = 0; i < count; ++i) results.plane(0)[i] = inside(polygon, x[i], y[i]) ? 1 : 0;
            };
          }};
}

template <class Real, class Angle>
bool inside_by_angle_sum(const Star& polygon, double x, double y, Angle angle) {
  Real sum = 0;
  for (std::size_t k = 0; k < star_corners; ++k) {
    const StarCorner &a = polygon[k], &b = polygon[(k + 1) % star_corners];
    sum += angle(Real(a.x) - Real(x), Real(a.y) - Real(y), Real(b.x) - Real(x), Real(b.y) - Real(y));
  }
  return std::abs(sum) > static_cast<Real>(3.14159265358979323846);
}

// The textbook's: the angle by its cosine, its sign by that of the cross product.
template <class Real>
bool inside_by_acos(const Star& polygon, double x, double y) {
  return inside_by_angle_sum<Real>(polygon, x, y, [](Real ax, Real ay, Real bx, Real by) {
    const Real lengths = std::sqrt(ax * ax + ay * ay) * std::sqrt(bx * bx + by * by);
    return std::copysign(std::acos((ax * bx + ay * by) / lengths), ax * by - ay * bx);
  });
}

template <class Real>
bool inside_by_atan2(const Star& polygon, double x, double y) {
  return inside_by_angle_sum<Real>(polygon, x, y, [](Real ax, Real ay, Real bx, Real by) {
    return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  });
}

// Crossings of the ray to the right, each edge with its lower end only; `side` is the sign of (b - a) x (p - a).
template <class Side>
bool inside_by_winding(const Star& polygon, double x, double y, Side side) {
  int winding = 0;
  for (std::size_t k = 0; k < star_corners; ++k) {
    const StarCorner &a = polygon[k], &b = polygon[(k + 1) % star_corners];
    if (a.y <= y && b.y > y && side(a, b, x, y) > 0) ++winding;
    if (b.y <= y && a.y > y && side(a, b, x, y) < 0) --winding;
  }
  return winding != 0;
}

template <class Real>
int rounded_side(const StarCorner& a, const StarCorner& b, double x, double y) {
  const Real value = (Real(b.x) - Real(a.x)) * (Real(y) - Real(a.y)) - (Real(b.y) - Real(a.y)) * (Real(x) - Real(a.x));
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// The product's, by exact orientations.
Variant<double> shipped_place() {
  return {.name = "winding, exact",
          .prepare = [](const Batch& batch) -> Variant<double>::Run {
            std::vector<glm::dvec2> polygon;
            for (const StarCorner& corner : polygon_of(batch)) polygon.emplace_back(corner.x, corner.y);
            const double *x = batch.truth.plane(0), *y = batch.truth.plane(1);
            return [=, count = batch.size()](Planes<double>& results) {
              for (std::size_t i = 0; i < count; ++i) {
                const PointPlace place = place_in_polygon(polygon, {x[i], y[i]});
                results.plane(0)[i] = place == PointPlace::inside ? 1 : place == PointPlace::boundary ? 0.5 : 0;
              }
            };
          },
          .ships = true};
}

// A star around (0.5, 0.5); points anywhere, or so many steps of binary32 beside an edge.
InputFamily polygon_family(const char* name, const char* text, int steps) {
  return {name, text, [steps](Random& random, std::size_t count) {
            std::vector<double> constants;
            for (std::size_t k = 0; k < star_corners; ++k) {
              // Points of a circle by rational parameters: no trigonometry, the same on every machine.
              const double turn = 4.0 * static_cast<double>(k) / star_corners, t = turn - std::floor(turn);
              const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
              const double radius = (k % 2 == 0 ? 0.48 : 0.2) * random.uniform(0.8, 1);
              const double quarter[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
              const auto q = static_cast<std::size_t>(turn);
              constants.push_back(static_cast<float>(0.5 + radius * quarter[q][0]));
              constants.push_back(static_cast<float>(0.5 + radius * quarter[q][1]));
            }
            const std::vector<double> at = constants;
            return drawn(random, 2, count, constants, [=](Random& r, double* in) {
              in[0] = static_cast<float>(r.uniform(0, 1));
              in[1] = static_cast<float>(r.uniform(0, 1));
              if (steps < 0) return;
              const auto k = static_cast<std::size_t>(r.integer(0, star_corners - 1)), next = (k + 1) % star_corners;
              const double t = r.uniform(0, 1);
              for (std::size_t axis = 0; axis < 2; ++axis) {
                const double edge = at[2 * k + axis] + t * (at[2 * next + axis] - at[2 * k + axis]);
                in[axis] = static_cast<float>(edge + r.integer(-steps, steps) * 0x1p-25);
              }
            });
          }};
}

}  // namespace

Operation point_in_polygon() {
  PlanarOperation<double> op;
  op.about = {.name = "point-in-polygon",
              .title = "whether a point lies in a star of twelve corners",
              .results = "inside",
              .format = binary64,
              .plotted = Measure::wrong,
              .target = 0,
              .reason = "the exact answer for every point"};
  op.families = {
      polygon_family("benign", "points anywhere in the star's box", -1),
      polygon_family("wide", "points within 2^-9 of an edge", 1 << 16),
      polygon_family("adversarial", "points within 2^-24 of an edge", 2),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* result) {
    using Number = NumberOf<decltype(result)>;
    int winding = 0;
    bool boundary = false;
    for (std::size_t k = 0; k < star_corners; ++k) {
      const std::size_t next = (k + 1) % star_corners;
      const Number ax = in.constant(2 * k), ay = in.constant(2 * k + 1), bx = in.constant(2 * next),
                   by = in.constant(2 * next + 1), x = in(0, i), y = in(1, i);
      const Number side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
      if (ay <= y && by > y && side > 0) ++winding;
      if (by <= y && ay > y && side < 0) --winding;
      const bool within = (x - ax) * (x - bx) <= 0 && (y - ay) * (y - by) <= 0;
      boundary = boundary || (side == 0 && within);
    }
    result->value = boundary ? 0.5 : winding != 0 ? 1.0 : 0.0;
  });
  op.measured = 0;
  op.events = {Measure::wrong};
  op.judge = [](const double* computed, const double* exact, EventCounts& events) {
    const bool either = exact[0] == 0.5 && (computed[0] == 0 || computed[0] == 1);
    if (computed[0] != exact[0] && !either) events.count(Measure::wrong);
  };
  op.variants = {
      by_c_library(deciding("angle sum by acos, fp32", inside_by_acos<float>)),
      by_c_library(deciding("angle sum by acos, fp64", inside_by_acos<double>)),
      by_c_library(deciding("angle sum by atan2, fp64", inside_by_atan2<double>)),
      deciding("winding, fp32",
               [](const Star& p, double x, double y) { return inside_by_winding(p, x, y, rounded_side<float>); }),
      deciding("winding, fp64",
               [](const Star& p, double x, double y) { return inside_by_winding(p, x, y, rounded_side<double>); }),
      shipped_place(),
  };
  op.compared = 8192;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy
