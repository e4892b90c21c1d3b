// One hidden-surface method on one frame, with all that it did.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/frame_surfaces.hpp"
#include "host/visibility/area_subdivision.hpp"
#include "host/visibility/bsp.hpp"
#include "host/visibility/depth_sort.hpp"
#include "host/visibility/paint.hpp"
#include "host/visibility/scan_line.hpp"
#include "morphcl/plan.hpp"
#include "morphcl/visibility.hpp"

namespace morphcl::hidden_surfaces {

struct MethodRun {
  explicit MethodRun(const Plan& plan);  // runs plan's method; Error as SurfaceVisibility has it

  VisibilityMethod method() const { return plan->visibility; }

  Plan plan;
  RasterGrid grid;
  std::vector<std::vector<reference::Vertex>> vertices;
  reference::FrameSurfaces frame;
  visibility::Pieces pieces;

  std::vector<visibility::Window> windows;    // warnock
  std::vector<visibility::SampleSpan> spans;  // watkins, row by row
  std::optional<visibility::Bsp> tree;        // bsp
  std::vector<visibility::Piece> order;       // painter, bsp: back to front
  visibility::ShownRows shown;                // of the whole picture
  std::vector<std::uint32_t> overdraw;        // surfaces that cover each pixel
  // Pixels that show another surface than the z-buffer has there: none, or the method is wrong.
  std::vector<std::size_t> differing;

  double seconds = 0;  // of the processor: what the method took, without what it tells here
  // Named, in the order of the method's steps.
  std::vector<std::pair<std::string, std::uint64_t>> counts;

 private:
  void run();
  void count_overdraw();
  void compare_with_z_buffer();
  void count(const char* name, std::uint64_t value) { counts.emplace_back(name, value); }
};

}  // namespace morphcl::hidden_surfaces
