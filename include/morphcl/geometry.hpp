// The geometry kit: boxes, spheres, lines, segments and planes; with orientation() and place_in_polygon() of
// numerics.hpp.
//
// Every decision is exact for the numbers given, of any size: a floating-point evaluation decides where it is further
// from 0 than its error bound, else integers of any length do. Points that are computed have coordinates that are the
// doubles nearest to the exact ones, ties to even, unless stated. Error(usage) for a coordinate that is not finite.
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "morphcl/numerics.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// How two things lie to each other. apart: no point in common. crossing: a point of one's interior is in the other's;
// of a segment and a surface: it runs through, from one side to the other. touching: all else.
enum class Contact { apart, touching, crossing };

// ---- boxes ----------------------------------------------------------------------------------------------------------

// All x with lower <= x <= upper, componentwise. The default box is empty, and so is one with NaN.
struct Box {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  bool contains(const glm::dvec3& point) const;
  glm::dvec3 center() const { return 0.5 * lower + 0.5 * upper; }  // of a box that is not empty
  glm::dvec3 corner(int i) const;  // i = 0..7: bit 0 takes upper.x, bit 1 upper.y, bit 2 upper.z
  void include(const glm::dvec3& point);
  void include(const Box& other);
};

Box box_of(std::span<const glm::dvec3> points);  // the smallest; of no points empty

// Boxes may reach to infinity. Of an empty one: apart. Boxes without thickness cross where each reaches beyond the
// other's start on every axis, as a sheet does within a solid.
Contact contact(const Box& a, const Box& b);
PointPlace place_in_box(const Box& box, const glm::dvec3& point);  // of a NaN: outside

// The min-max test of two polygons, or of two edges, in the plane: whether their axis-aligned boxes are apart, so that
// they certainly do not overlap; else they may. Of no corners: apart.
Contact min_max_test(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b);

// ---- spheres --------------------------------------------------------------------------------------------------------

struct Sphere {
  glm::dvec3 center{0.0};
  double radius = 0;
};

// As balls. By the distance of their centres and the sum of their radii; equal: touching. Error(usage) for a radius
// that is negative or not finite, here and below.
Contact contact(const Sphere& a, const Sphere& b);
PointPlace place_in_sphere(const Sphere& sphere, const glm::dvec3& point);

// The smallest sphere around points, nearly: every point is in it, exactly, and none that is smaller than
// `min_radius` holds them all. So its radius is at most radius - min_radius too large, which is proved anew for
// each result; the tests hold that to 1e-9 of the radius, and it mostly is some 1e-15.
struct EnclosingSphere {
  Sphere sphere;
  double min_radius = 0;
};

// Method: Welzl's (1991) problem, solved by pivoting on the farthest point (Gaertner 1999): the smallest sphere of up
// to 4 points is replaced by that of these and the point farthest from its centre until nothing is gained. Then the
// radius is the largest distance, rounded upwards. The proof of min_radius: for weights l_i >= 0 of sum 1 and
// c = sum l_i p_i, every sphere that holds the p_i has a radius of sqrt(sum l_i |p_i - c|^2) at least.
// O(points x rounds), some 10 rounds. Error(usage) for no points, or a coordinate beyond 1e300.
EnclosingSphere enclosing_sphere(std::span<const glm::dvec3> points);
EnclosingSphere enclosing_sphere(std::span<const glm::vec3> points);

// ---- segments and lines ---------------------------------------------------------------------------------------------
//
// A segment has both its ends; its interior is what lies between them. Where its ends are equal it is a point, and
// never more than touching; lines and planes must be given by more than a point: Error(usage).

struct Segment3 {
  glm::dvec3 from{0.0}, to{0.0};
};

// What a segment has in common with something, from the point nearest to its `from` to the one nearest to its `to`; of
// one point, both are equal. Not to be read where it is apart.
struct Intersection3 {
  Contact contact = Contact::apart;
  glm::dvec3 from{0.0}, to{0.0};
};

// The line through both ends. tangent: touching. It enters the sphere at from + enter (to - from) and leaves it at
// `leave`, each within 8u relative; barring underflow and overflow.
struct LineSphere {
  Contact contact = Contact::apart;
  double enter = 0, leave = 0;
};

// Error(usage) for a line whose ends are equal.
LineSphere intersect_line(const Segment3& line, const Sphere& sphere);

// All x with normal . x = offset; the normal needs no unit length.
struct Plane {
  glm::dvec3 normal{0.0, 0.0, 1.0};
  double offset = 0;
};

// 1: on the side that the normal points to, -1: on the other, 0: in the plane. Error(usage) for a normal of 0.
int side_of_plane(const Plane& plane, const glm::dvec3& point);

// A segment in the plane touches it all along; one with an end in it touches it there.
Intersection3 intersect(const Segment3& segment, const Plane& plane);

// crossing: some of it is inside the box. Boxes are finite; of an empty one: apart.
Intersection3 intersect(const Segment3& segment, const Box& box);

}  // namespace morphcl
#pragma GCC visibility pop
