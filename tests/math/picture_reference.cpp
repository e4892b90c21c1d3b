#include "tests/math/picture_reference.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <map>

#include "tests/math/reference_real.hpp"

namespace morphcl::reference {

namespace {

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Real& s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }

glm::dvec3 rounded(const Vector& a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

Real degrees(double angle) { return angle * boost::math::constants::pi<Real>() / 180; }

// The board with its axes: across, up, and towards the viewer.
struct Drawing {
  Vector across, up, towards;
  bool central = false;
  Vector eye{};        // where the camera stands; the centre of a central projection
  Vector projector{};  // of parallel projections: the direction of the lines of sight, towards the viewer
  Vector origin{};     // of the board
  Real left{}, right{}, bottom{}, top{};
};

void set_window(Drawing& d, const Real& left, const Real& right, const Real& bottom, const Real& top) {
  d.left = left;
  d.right = right;
  d.bottom = bottom;
  d.top = top;
}

// Parallel: the board through (0, 0, 0), the camera 10 before it.
Drawing parallel(const Vector& across, const Vector& up, const Vector& towards, const Real& side) {
  Drawing d{across, up, towards};
  d.projector = towards;
  d.eye = Real(10) * towards;
  set_window(d, -side, side, -side, side);
  return d;
}

// The front view with other projectors: 1 unit to the back is drawn (x, y) away; the camera is 5 before the board.
Drawing oblique(const Real& x, const Real& y) {
  Drawing d = parallel({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 2);
  d.projector = {x, y, 1};
  d.eye = {0, 0, 5};
  return d;
}

// The object turned about y by -azimuth, then about x by the elevation, and seen from the front.
Drawing turned(double azimuth_degrees, double elevation_degrees) {
  const Real a = degrees(azimuth_degrees), e = degrees(elevation_degrees);
  return parallel({cos(a), 0, -sin(a)}, {-sin(a) * sin(e), cos(e), -cos(a) * sin(e)},
                  {sin(a) * cos(e), sin(e), cos(a) * cos(e)}, 2);
}

Drawing isometric() {
  const Real r2 = sqrt(Real(2)), r3 = sqrt(Real(3)), r6 = sqrt(Real(6));
  return parallel({1 / r2, 0, -1 / r2}, {-1 / r6, 2 / r6, -1 / r6}, {1 / r3, 1 / r3, 1 / r3}, 2);
}

// Of technical drawing: x and y drawn sqrt(8)/3 as long, z half of that; x leads down at the angle whose sine is 1/8, z
// at the one whose cosine is 3/4.
Drawing dimetric() {
  const Real f = sqrt(Real(8)) / 3;
  const Vector across{f * sqrt(Real(63)) / 8, 0, -f / 2 * 3 / 4}, up{-f / 8, f, -f / 2 * sqrt(Real(7)) / 4};
  const Vector towards{across[1] * up[2] - across[2] * up[1], across[2] * up[0] - across[0] * up[2],
                       across[0] * up[1] - across[1] * up[0]};
  return parallel(across, up, towards, 2);
}

// The board stands through `target`, at right angles to the way to the eye, its upright axis as upright as it can be.
Drawing central(const Vector& eye, const Vector& target) {
  const Vector way = eye - target;
  const Vector towards = 1 / sqrt(dot(way, way)) * way;
  const Real horizontal = sqrt(towards[0] * towards[0] + towards[2] * towards[2]);
  Drawing d{{towards[2] / horizontal, 0, -towards[0] / horizontal},
            {-towards[0] * towards[1] / horizontal, horizontal, -towards[2] * towards[1] / horizontal},
            towards};
  d.central = true;
  d.eye = eye;
  d.origin = target;
  return d;
}

std::map<std::string, Drawing> make_drawings() {
  std::map<std::string, Drawing> all;
  const Real s = Real(3) / 2;
  all["front"] = parallel({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, s);
  all["back"] = parallel({-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, s);
  all["right"] = parallel({0, 0, -1}, {0, 1, 0}, {1, 0, 0}, s);
  all["left"] = parallel({0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, s);
  all["top"] = parallel({1, 0, 0}, {0, 0, -1}, {0, 1, 0}, s);
  all["bottom"] = parallel({1, 0, 0}, {0, 0, 1}, {0, -1, 0}, s);
  all["isometric"] = isometric();
  all["dimetric"] = dimetric();
  all["trimetric"] = turned(35, 20);
  const Real half = sqrt(Real(2)) / 2;
  all["cavalier"] = oblique(half, half);
  all["cabinet"] = oblique(half / 2, half / 2);
  const Real factor = 1 / tan(degrees(55));
  all["oblique"] = oblique(factor * cos(degrees(150)), factor * sin(degrees(150)));
  all["central"] = central({0, 0, 6}, {0, 0, 0});
  set_window(all["central"], -2, 2, -2, 2);
  all["two_point"] = central({Real(7) / 2, 2, Real(9) / 2}, {0, 2, 0});
  set_window(all["two_point"], Real(1.8) * -1, 1.8, -4, 0);
  // The near plane at 3 is half as far as the board through the target at 6.
  all["frustum"] = central({Real(3) / 2, 2, 6}, {Real(3) / 2, 2, 0});
  set_window(all["frustum"], 2 * -1.75, 2 * 0.25, 2 * Real(-1.9), 2 * Real(-0.1));
  Drawing& p = all["perspective"] = central({3.5, 2.7, 4.4}, {0, 0, 0});
  const Real height = sqrt(dot(p.eye, p.eye)) * tan(degrees(20));
  set_window(p, -height * 4 / 3, height * 4 / 3, -height, height);
  return all;
}

const Drawing& drawing_of(const std::string& name) {
  static const std::map<std::string, Drawing> all = make_drawings();
  return all.at(name);
}

}  // namespace

PicturePoint draw_point(const std::string& drawing, const glm::dvec3& point) {
  const Drawing& d = drawing_of(drawing);
  const Vector p{point.x, point.y, point.z};
  const Vector line = d.central ? d.eye - p : d.projector;
  const Vector on_board = p + dot(d.origin - p, d.towards) / dot(line, d.towards) * line - d.origin;
  return {exact(dot(on_board, d.across)), exact(dot(on_board, d.up)), exact(dot(d.eye - p, d.towards))};
}

PictureWindow picture_window(const std::string& drawing, double aspect) {
  const Drawing& d = drawing_of(drawing);
  const Real width = d.right - d.left, height = d.top - d.bottom;
  Real more_x = (height * aspect - width) / 2, more_y = (width / aspect - height) / 2;
  if (more_x < 0) more_x = 0;
  if (more_y < 0) more_y = 0;
  return {static_cast<double>(Real(d.left - more_x)), static_cast<double>(Real(d.right + more_x)),
          static_cast<double>(Real(d.bottom - more_y)), static_cast<double>(Real(d.top + more_y))};
}

SightLine sight_line(const std::string& drawing, double x, double y) {
  const Drawing& d = drawing_of(drawing);
  const Vector on_board = d.origin + Real(x) * d.across + Real(y) * d.up;
  const Vector direction = d.central ? on_board - d.eye : Real(-1) * d.projector;
  return {rounded(on_board), rounded(direction), static_cast<double>(dot(d.eye - on_board, d.towards)),
          static_cast<double>(Real(-dot(direction, d.towards)))};
}

}  // namespace morphcl::reference
