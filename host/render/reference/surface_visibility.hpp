// Which primitives a frame's pixels show, found by another method than the z-buffer, with the same result: what
// find_visible() gives with one sample a pixel, bit for bit.
//
// The painter's algorithm and the BSP tree put all triangles in an order, blended ones too. Warnock's and Watkins' find
// what is opaque; what is blended in front of it is gathered and sorted pixel by pixel, as with the z-buffer. Lines are
// drawn into what was found, by their depths.
#pragma once

#include <memory>
#include <optional>

#include "host/render/reference/frame_surfaces.hpp"
#include "host/visibility/area_subdivision.hpp"
#include "host/visibility/bsp.hpp"
#include "host/visibility/depth_sort.hpp"
#include "host/visibility/scan_line.hpp"
#include "morphcl/visibility.hpp"

namespace morphcl::reference {

class SurfaceVisibility {
 public:
  // By plan.visibility, which is not z_buffer; plan.samples is 1. Error(bad_input) where a method would need more than
  // max_visibility_pieces. What it is given must outlive it.
  SurfaceVisibility(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices);
  ~SurfaceVisibility();

  // Replaces `visible`; for any thread. Returns where the stored depths had to decide.
  std::vector<visibility::ShownRows::WithinError> find_visible(const Rows& rows, Visibility& visible) const;

 private:
  visibility::ShownRows find_shown(const Rows& rows) const;

  const FramePlan& plan_;
  const RasterGrid& grid_;
  const std::vector<std::vector<Vertex>>& vertices_;
  FrameSurfaces surfaces_;
  visibility::Pieces pieces_;
  std::vector<visibility::Piece> back_to_front_;        // painter, bsp
  std::optional<visibility::ShownRows> whole_picture_;  // warnock
};

}  // namespace morphcl::reference
