// N and P against geometry in 113 bits that shares no arithmetic with the renderers: exact planes, exact rays through
// the pixels' centres, exact shares of the vertices.
//
// The bounds, with u the unit roundoff of binary32 (`roundoff`) and h = 1/512 pixel (`snap`), by which snapping moves a
// corner at most:
//   distance  1 / d (in parallel projections d) is affine on the screen. Corners that moved by h interpolate it where
//             it is up to h away: h times what it changes by to the next pixel, along both axes. Rounding: of a
//             vertex's own distance, three fma of rounded numbers, 8 u times the sum of their magnitudes; of shares,
//             3 u an area, 1 u by w, 3 u of sums, 1 u of the quotient: 20 u of d is more.
//   P         the distance's error along the ray; each component of the ray 3 roundings of its terms, 3 more on the
//             way to the world, whose numbers are rounded once: 8 u of all terms is more.
//   N         half of an ulp of a half below 1, 2^-12; what N changes by within h, half as much again as to the
//             corners of that square; rounding of shares as above, and of vertex normals, some ten steps: 64 u.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>

#include "host/math/unit_roundoff.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/visibility.hpp"
#include "lab/frame_error/precise_frame.hpp"
#include "morphcl/numerics.hpp"
#include "tests/render/channel_scenes.hpp"

namespace morphcl::test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits
using Precise = accuracy::PreciseFrame<accuracy::TrueGeometry<Quad>>;
using Vector = accuracy::Vector3<Quad>;

constexpr double roundoff = unit_roundoff<float>, snap = 1.0 / 512;

double to_double(const Quad& value) { return static_cast<double>(value); }
double length(const Vector& v) { return to_double(sqrt(accuracy::dot(v, v))); }

// A triangle in eye space and what rays through pixels meet of it.
class ExactTriangle {
 public:
  ExactTriangle(const Precise& precise, std::uint32_t object_index, std::uint32_t primitive)
      : camera_(precise.camera()), object_(precise.objects()[object_index]) {
    const glm::uvec3 triangle = object_.mesh->triangles[primitive];
    for (int i = 0; i < 3; ++i) {
      const accuracy::PreciseVertex<Quad>& vertex = object_.vertices[triangle[i]];
      corner_[i] = accuracy::times_point(object_.object_to_eye, vertex.position);
      normal_[i] = vertex.normal;
      const accuracy::Row<Quad>& row = object_.object_to_eye[2];
      const Vector& p = vertex.position;
      const double terms = to_double(abs(row[0] * p.x) + abs(row[1] * p.y) + abs(row[2] * p.z) + abs(row[3]));
      const double distance = to_double(vertex.distance);
      terms_ = std::max(terms_, camera_.parallel ? terms : terms / distance);
      distance_ = std::max(distance_, std::abs(distance));
    }
    plane_ = accuracy::cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
  }

  Quad distance(double x, double y) const {
    const Quad constant = accuracy::dot(plane_, corner_[0]);
    if (!camera_.parallel) return constant / accuracy::dot(plane_, place(x, y, Quad(1)));
    const Vector start = place(x, y, Quad(0)), way = place(x, y, Quad(1)) - start;
    return (constant - accuracy::dot(plane_, start)) / accuracy::dot(plane_, way);
  }

  // What is affine on the screen.
  Quad affine(double x, double y) const { return camera_.parallel ? distance(x, y) : Quad(1 / distance(x, y)); }

  double distance_bound(double x, double y) const {
    const double d = to_double(distance(x, y));
    const double change =
        snap * (to_double(abs(affine(x + 1, y) - affine(x, y))) + to_double(abs(affine(x, y + 1) - affine(x, y))));
    if (camera_.parallel) return change + roundoff * (20 * distance_ + 8 * terms_);
    return d * d * change * (1 + 4 * d * change) + d * roundoff * (20 + 8 * terms_);
  }

  // The point of eye space at a distance that shows at a place of the picture, of pixels whose centres are whole
  // numbers.
  Vector place(double x, double y, const Quad& d) const {
    const Vector first = camera_.position(0, 0, d);
    return first + (camera_.position(1, 0, d) - first) * Quad(x) + (camera_.position(0, 1, d) - first) * Quad(y);
  }

  // Unit length, eye space, outwards. Smooth: of the vertices' unit normals by their shares; else the face's.
  Vector outside(double x, double y) const {
    if (object_.shading != Shading::smooth) {
      const Vector face = object_.mirrored ? -plane_ : plane_;
      return accuracy::unit(face);
    }
    const Vector at = place(x, y, distance(x, y));
    const Quad all = accuracy::dot(plane_, plane_);
    Vector sum;
    for (int i = 0; i < 3; ++i) {
      const Vector opposite = accuracy::cross(corner_[(i + 1) % 3] - at, corner_[(i + 2) % 3] - at);
      sum = sum + normal_[i] * Quad(accuracy::dot(plane_, opposite) / all);
    }
    return accuracy::unit(sum);
  }

  // As it is seen: turned to the eye on the back of a double-sided object.
  bool shows_back(double x, double y) const {
    const Vector face = object_.mirrored ? -plane_ : plane_;
    return !camera_.is_seen_from_outside(face, place(x, y, distance(x, y)));
  }

  double normal_bound(double x, double y) const {
    const Vector here = outside(x, y);
    double change = 0;
    for (const double dx : {-snap, snap})
      for (const double dy : {-snap, snap}) change = std::max(change, length(outside(x + dx, y + dy) - here));
    return 0x1p-12 + 1.5 * change + roundoff * (64 + 16 * (camera_.parallel ? 1 : terms_));
  }

 private:
  const accuracy::PreciseCamera<Quad>& camera_;
  const accuracy::PreciseObject<Quad>& object_;
  Vector corner_[3], normal_[3], plane_;
  double terms_ = 0, distance_ = 0;  // largest of the corners; terms in perspective over their distance
};

Vector to_world(const accuracy::PreciseCamera<Quad>& camera, const Vector& direction) {
  const auto& m = camera.world_to_eye;
  const auto part = [&](int c) -> Quad {
    return m[0][c] * direction.x + m[1][c] * direction.y + m[2][c] * direction.z;
  };
  return {part(0), part(1), part(2)};
}

Vector point_to_world(const accuracy::PreciseCamera<Quad>& camera, const Vector& point) {
  const auto& m = camera.world_to_eye;
  return to_world(camera, {point.x - m[0][3], point.y - m[1][3], point.z - m[2][3]});
}

// Of the world position at a pixel, beyond what the distance's error makes of it.
double position_rounding(const FramePlan& plan, int x, int y, double distance) {
  const CameraConstants& camera = plan.camera;
  const double ray = std::abs((x + 0.5) * camera.ray[0]) + std::abs(double{camera.ray[1]}) +
                     std::abs((y + 0.5) * camera.ray[2]) + std::abs(double{camera.ray[3]}),
               slant = std::abs(double{camera.slant[0]}) + std::abs(double{camera.slant[1]});
  const double terms = camera.parallel ? ray + std::abs(distance) * (1 + slant) : distance * (1 + ray);
  double eye = 0;
  for (const Row& row : plan.eye_to_world) eye += std::abs(double{row[3]});
  return 8 * roundoff * (terms + eye);
}

struct Worst {
  double of_bound = 0;  // the largest error, in its bound
  int compared = 0;
  void add(double error, double bound) {
    of_bound = std::max(of_bound, error / bound);
    ++compared;
  }
};

TEST(ChannelAccuracy, NormalsAndPositionsAreThoseOfExactGeometry) {
  const auto renderer = make_reference_renderer(2);
  Worst normals, positions;
  for (TestScene& test : test_scenes(150, 85, 300)) {
    // Lines have no normals. Clipped corners are computed ones: what clipping cuts is left out below.
    bool is_chosen = false;
    for (const char* const name : {"sphere to cube", "across the near plane", "mirrored and two-sided", "orthographic",
                                   "oblique", "many targets", "faces under point lights", "horizontal perspective"})
      is_chosen |= test.name == name;
    if (!is_chosen) continue;
    SCOPED_TRACE(test.name);
    test.scene.image.channels = {Channel::normal, Channel::position};
    const Plan plan = plan_frame(test.scene, 0);
    FrameBuffer frame = plan.make_frame();
    renderer->forget();
    renderer->render(plan, frame);
    const RasterGrid grid(plan->width, plan->height);
    std::vector<std::vector<reference::Vertex>> vertices;
    for (const Draw& draw : plan->draws) vertices.push_back(reference::project_vertices(draw, *plan, grid));
    const reference::Visibility visible = reference::find_visible(*plan, grid, vertices);
    const Precise precise(test.scene, 0);
    int compared = 0;
    for (int y = 0; y < plan->height; ++y)
      for (int x = 0; x < plan->width; ++x) {
        const reference::Sample& sample = visible.sample(x, y);
        if (sample.order == reference::no_order || sample.piece != reference::no_piece) continue;
        const Draw& draw = plan->draws[sample.draw];
        if (draw.normals == NormalSource::none || (x + y) % 3 != 0) continue;
        const ExactTriangle exact(precise, draw.object, sample.primitive);
        // Seen edge-on, what is within h of a pixel is the whole triangle.
        const double distance = to_double(exact.distance(x, y)), bound_of_distance = exact.distance_bound(x, y);
        if (!(bound_of_distance < 0.05 * std::abs(distance))) continue;
        const auto at = static_cast<std::size_t>(x);

        const Vector place = precise.camera().position(x, y, exact.distance(x, y)),
                     ray = precise.camera().position(x, y, exact.distance(x, y) + 1) - place,
                     world = point_to_world(precise.camera(), place);
        const Vector shown{Quad(frame.float_row(Channel::position, 0, y)[at]),
                           Quad(frame.float_row(Channel::position, 1, y)[at]),
                           Quad(frame.float_row(Channel::position, 2, y)[at])};
        positions.add(length(shown - world),
                      bound_of_distance * length(ray) + position_rounding(*plan, x, y, distance));

        Vector normal = to_world(precise.camera(), exact.outside(x, y));
        if (draw.double_sided && exact.shows_back(x, y)) normal = -normal;
        const auto half = [&](int c) { return from_half(frame.half_row(Channel::normal, c, y)[at]); };
        const double worst = std::max({std::abs(half(0) - to_double(normal.x)), std::abs(half(1) - to_double(normal.y)),
                                       std::abs(half(2) - to_double(normal.z))});
        const double bound = exact.normal_bound(x, y);
        if (bound < 0.05) normals.add(worst, bound);
        ++compared;
      }
    EXPECT_GT(compared, 300);
  }
  EXPECT_LE(normals.of_bound, 1) << normals.compared << " compared";
  EXPECT_LE(positions.of_bound, 1) << positions.compared << " compared";
  EXPECT_GT(normals.of_bound, 0.3) << "the bound is far from what can happen";
  EXPECT_GT(positions.of_bound, 0.1) << "the bound is far from what can happen";
  RecordProperty("normals", std::to_string(normals.of_bound));
  RecordProperty("positions", std::to_string(positions.of_bound));
}

}  // namespace
}  // namespace morphcl::test
