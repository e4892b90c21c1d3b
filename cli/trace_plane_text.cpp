#include "cli/trace_plane_text.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/console.hpp"
#include "cli/table.hpp"
#include "cli/trace_words.hpp"

namespace morphcl::cli {

namespace {

std::string plane_row(const glm::dmat3& matrix, int row) {
  return fmt::format("[ {} {} {} ]", short_number(matrix[0][row]), short_number(matrix[1][row]),
                     short_number(matrix[2][row]));
}

}  // namespace

void print_plane_text(const TracePlane& plane) {
  print_result("");
  print_result(
      fmt::format("the same in the plane: the camera is orthographic and looks along an axis, so 3 x 3 matrices do; "
                  "x, y of the plane are {} of the world",
                  plane.axes));
  print_result(fmt::format("  world ({}, {}, 1)", short_number(plane.start.x), short_number(plane.start.y)));
  for (const TracePlaneStep& step : plane.steps) {
    print_result(fmt::format("{}: {}", step.name, step.detail));
    std::vector<std::vector<std::string>> rows = {{"  matrix", "inverse", "composite, from the world"}};
    for (int row = 0; row < 3; ++row)
      rows.push_back(
          {"  " + plane_row(step.matrix, row), plane_row(step.inverse, row), plane_row(step.composite, row)});
    for (const std::string& line : aligned(rows)) print_result(line);
    print_result(fmt::format("  the point is now ({}, {}, {})", short_number(step.point.x), short_number(step.point.y),
                             short_number(step.point.z)));
  }
}

}  // namespace morphcl::cli
