// Binary space partition of flat polygons: an order from back to front exists for
// every viewpoint, also where polygons overlap in a circle or cut each other, because those are split.
//
// Method: Fuchs, Kedem and Naylor (1980); split corners as intersections of planes, never of edges that were rounded
// (Bernstein and Fussell 2009): every plane is that of an input polygon, every side is decided in integers, so no part
// drifts off its plane and none lies on both sides of a node.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "morphcl/hidden_surfaces.hpp"

namespace morphcl {

// Half of space beside a node's plane; points on it count as in front.
struct PlaneSide {
  IntegerPlane plane;
  bool front = true;
};

// A convex part of a polygon: what is on all these sides.
struct PolygonPart {
  int polygon = 0;
  std::vector<PlaneSide> sides;
};

class BspTree {
 public:
  // Planes are taken in the order of the polygons, of which there may be 4096: Error(usage).
  explicit BspTree(const std::vector<FlatPolygon>& polygons);
  ~BspTree();
  BspTree(BspTree&&) noexcept;

  // Back to front for the viewpoint (x, y, z) / w; w = 0: from that direction. Of parts in one plane the one of the
  // lower index comes last.
  std::vector<PolygonPart> back_to_front(const std::array<int, 4>& viewpoint) const;

 private:
  struct Node;
  std::unique_ptr<Node> root_;
};

}  // namespace morphcl
