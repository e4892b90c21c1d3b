// Where points are drawn, by the definitions of descriptive geometry: a board in space, and the line that leads from
// the point to the eye, or along the projectors, cut with it. In 168 bits; it shares no matrices and no code with what
// it judges.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "tests/math/reference.hpp"

namespace morphcl::reference {

struct PicturePoint {
  Exact x, y;      // on the board, from its origin along its axes
  Exact distance;  // from the eye along the view axis
};

// A drawing of docs/projections.md by its name, the numbers of its shot written down once more. Error:
// std::out_of_range.
PicturePoint draw_point(const std::string& drawing, const glm::dvec3& point);

// The part of the board that the picture shows, given its width / height.
struct PictureWindow {
  double left, right, bottom, top;
};
PictureWindow picture_window(const std::string& drawing, double aspect);

// The line of sight through a point of the board: origin and a direction that leads away from the viewer.
struct SightLine {
  glm::dvec3 origin, direction;
  double origin_distance, distance_per_step;  // along the view axis, at the origin and per unit of the direction
};
SightLine sight_line(const std::string& drawing, double x, double y);

}  // namespace morphcl::reference
