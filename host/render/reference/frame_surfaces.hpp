// A frame's triangles as hidden-surface algorithms take them, in drawing order, and what the z-buffer stores of them.
#pragma once

#include <vector>

#include "host/render/reference/screen_primitives.hpp"
#include "host/render/reference/surface_depth.hpp"
#include "host/visibility/screen_surfaces.hpp"

namespace morphcl::reference {

class FrameSurfaces : private visibility::StoredDepths {
 public:
  FrameSurfaces(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices);
  FrameSurfaces(const FrameSurfaces&) = delete;
  FrameSurfaces& operator=(const FrameSurfaces&) = delete;

  const visibility::ScreenSurfaces& surfaces() const { return surfaces_; }
  const std::vector<Piece>& pieces() const { return pieces_; }  // as in Visibility
  bool has_lines() const { return has_lines_; }

  // What the z-buffer has of a surface at a pixel that it covers.
  Sample sample(visibility::SurfaceId surface, int x, int y) const;
  const Sample& identity(visibility::SurfaceId surface) const { return drawn_[surface].identity; }

 private:
  struct Drawn {
    Sample identity;  // without depth
    SurfaceDepth depth;
  };
  void add(const ScreenTriangle& triangle, const PrimitiveIdentity& identity);

  bool shows(visibility::SurfaceId surface, int x, int y) const override;
  bool is_in_front(visibility::SurfaceId a, visibility::SurfaceId b, int x, int y) const override;

  const FramePlan& plan_;
  visibility::ScreenSurfaces surfaces_;
  std::vector<Drawn> drawn_;
  std::vector<Piece> pieces_;
  bool has_lines_ = false;
};

}  // namespace morphcl::reference
