// The built-in solids.
//
// Closed solids are wound counter-clockwise seen from outside; normals point outwards and have unit length. Unless
// stated the solids are centred on the origin, y is up, and nothing reaches further than 1 from the centre along an
// axis.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "morphcl/mesh.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// How finely a curved solid is cut: u around, v from pole to pole (or along the other direction).
struct Segments {
  int u = 0, v = 0;
};

struct SolidInfo {
  std::string_view name;
  Segments minimum;  // {0, 0}: the solid has no segments
  Segments standard;
  long long (*vertices)(Segments);  // how many a mesh has; segments below 2^27 each, none checked
  std::string_view description;
  Mesh (*make)(Segments);  // does not check the segments; make_solid does
};

// All solids, in the order of the documentation.
const std::vector<SolidInfo>& solids();

// The solid of that name, or null.
const SolidInfo* find_solid(std::string_view name);

// The solid's mesh, with its standard segments when none are given. Error(usage): an unknown name, segments for a solid
// that has none, fewer than its minimum, or so many that the mesh would have more than max_solid_vertices vertices.
Mesh make_solid(std::string_view name, std::optional<Segments> segments = std::nullopt);

constexpr long long max_solid_vertices = 1LL << 27;

// How many vertices make_solid would make. Throws the same errors, and makes nothing.
long long solid_vertices(std::string_view name, std::optional<Segments> segments = std::nullopt);

// The makers below do not check their segments: make_solid does. Vertex (i, j), i from 0 to u and j from 0 to v, has
// the index j (u+1) + i; the teapot has its patches one after the other, sphere_to_cube its faces.

// The classic pyramid that grows into a box, z up, in its own coordinates: base z = 30 from (50, 50) to (150, 150), and
// all four top corners in the apex (100, 100, 100). Target "cube" (absolute): top corners above the base's at z = 100.
// 8 vertices, 12 triangles (four of them without area at weight 0), 12 edges, no normals. The box's centre is
// (100, 100, 65).
Mesh make_pyramid_to_cube();

// Half-edge 1; 24 vertices, so that each face has its own normal; 12 edges.
Mesh make_cube();

// Radius 1. (u+1)(v+1) vertices: vertex (i, j) at the angle phi = 360 i/u degrees around and theta = 180 j/v from the
// upper pole is (sin theta sin phi, cos theta, sin theta cos phi). 2u(v-1) triangles.
Mesh make_sphere(Segments segments);

// A sphere of radius 1 that is a cube blown up, with the absolute target "cube" of half-edge 1. Each of the cube's
// edges is cut at equal angles seen from the centre: n = u/4 cells along x and z, m = v/2 cells along y, both rounded
// up, so that a cell on the side is 90/n degrees wide and 90/m high. The faces +x, -x, +y, -y, +z, -z follow each
// other, each a grid of its own: along an edge two vertices lie at the same place, in a corner three. Their normals are
// equal on the sphere, and on the cube those of their faces, which makes its edges sharp. On a face across axis a,
// vertex (i, j) has the cube's coordinates tan(90 i/n_b - 45 degrees) along the next axis b (of x, y, z, x, ...) and
// tan(90 j/n_c - 45 degrees) along the one after, and the index j (n_b + 1) + i; its place on the sphere is in the same
// direction. 4(n+1)(m+1) + 2(n+1)^2 vertices, 8nm + 4n^2 triangles, each with an area in every pose.
Mesh make_sphere_to_cube(Segments segments);
long long sphere_to_cube_vertices(Segments segments);

// Ring of radius 0.7 about the y axis with a tube of radius 0.3: vertex (i, j), at phi = 360 i/u around the axis and
// psi = 360 j/v around the tube, is (r sin phi, -0.3 sin psi, r cos phi) with r = 0.7 + 0.3 cos psi.
Mesh make_torus(Segments segments);

// The square from -1 to 1 in the xz plane, facing +y; i runs along x, j along z. Not closed.
Mesh make_grid(Segments segments);

// A cylinder of radius 1 about the y axis, from y = -1 to 1; the side is cut into v rows. Its rows are, downwards, the
// upper centre and rim facing up, the v+1 rows of the side facing outwards, the lower rim and centre facing down:
// (u+1)(v+5) vertices with sharp rims, 2u(v+1) triangles.
Mesh make_cylinder(Segments segments);

// A cone: the cylinder with its upper rim in the apex (0, 1, 0). The same triangles, so that one is a morph target of
// the other; those at the apex have no area.
Mesh make_cone(Segments segments);

// A right prism over a regular polygon of u sides about the y axis, its corners on the circle of radius 1, the first in
// +z; from y = -1 to 1, the sides cut into v rows. Each side has vertices of its own, so that its edges are sharp:
// 2u(v+1) of the sides, then u+1 of the upper and u+1 of the lower face, whose centre comes first. Its edges are those
// of the solid: 3u, cut into v pieces along y.
Mesh make_prism(Segments segments);

// The surface that a profile of points (radius, y) sweeps when it turns once about the y axis, cut into u pieces
// around. The profile runs downwards on the outside: from the axis to the axis, or with its first point as its last,
// the surface is closed. Each of its pieces is a band of its own with 2(u+1) vertices, so that the profile's corners
// are sharp: normals are those of the cone that the band is part of. A piece that goes nowhere, or along the axis, has
// none. Error(usage): fewer than two points, more than max_solid_vertices vertices, a radius below 0, a number that is
// not finite, no piece with an area.
Mesh make_revolution(std::span<const glm::dvec2> profile, int u);

// A curve through points, drawn as lines: v edges from each point to the next, and no triangles. Between points it is
// the cubic with default_tangents() at evenly spaced parameters: those of Catmull and Rom. Error(usage): fewer than two
// points, v below 1, more than max_solid_vertices vertices, a number that is not finite.
Mesh make_curve(std::span<const glm::dvec3> points, int v);

// Newell's teapot from its 32 bicubic Bezier patches, each cut into u x v quads, in the size of GLUT's teapot of size
// 1: y up, spout towards +x, half the classic scale, lowered so that the classic height 1.5 is y = 0; so x is in
// [-1.5, 1.7171], y in [-0.75, 0.825], z in [-1, 1]. So that nothing shows through it where only front faces are drawn,
// the patches are followed by triangles between their vertices, a flat ring from the lid's edge to the rim and the ends
// of the handle, and by the four patches of the spout once more, turned inside out: what is seen through its mouth.
// 36 (u+1)(v+1) vertices. Only the spout has open ends.
Mesh make_teapot(Segments segments);

}  // namespace morphcl
#pragma GCC visibility pop
