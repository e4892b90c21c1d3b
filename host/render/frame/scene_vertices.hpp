// The reference's view of kernels/project_vertices.h: one vertex at a time.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/raster_grid.hpp"

namespace morphcl::reference {

struct ClipPoint {
  float x, y, z, w;
};

struct ScreenVertex {
  int x, y;     // sub-pixels, the nearest ones
  float depth;  // z / w; for forward depth buffers the distance along the view axis
  float inverse_w;
  int rest_x = 0, rest_y = 0;  // from there to where the vertex is, in corner units

  // In corner units.
  std::int64_t corner_x() const { return std::int64_t{x} * layout::corner_units + rest_x; }
  std::int64_t corner_y() const { return std::int64_t{y} * layout::corner_units + rest_y; }
};

struct Vertex {
  glm::vec3 position;  // morphed, object space
  ClipPoint clip;
  int outcode;  // 0: `screen` holds
  ScreenVertex screen;
  glm::vec3 normal;  // unit, eye space; of draws that are smooth or show the mesh's normals
  glm::vec4 color;   // of draws with vertex colours
};

std::vector<Vertex> project_vertices(const Draw& draw, const FramePlan& plan, const RasterGrid& grid);

// ((m3 + z m2) + y m1) + x m0, each step one fma.
float row_times_point(const Row& row, const glm::vec3& p);
float row_times_vector(const std::array<float, 3>& row, const glm::vec3& v);

float near_distance(float z, float w, const FramePlan& plan);

ScreenVertex to_screen(const ClipPoint& p, const RasterGrid& grid);
ScreenVertex to_screen(const ClipPoint& p, const RasterGrid& grid, const FramePlan& plan);  // for its depth buffer

}  // namespace morphcl::reference
