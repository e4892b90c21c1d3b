#include "host/scene/shot/morph_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace morphcl {

void add_shape(const Mesh& shape, const std::string& name, const ShotValue& place, Mesh& base) {
  if (shape.positions.size() != base.positions.size() || shape.triangles.size() != base.triangles.size() ||
      (base.triangles.empty() && shape.edges.size() != base.edges.size()))
    place.fail(
        fmt::format("\"{}\" has {} vertices, {} triangles and {} edges, and \"{}\", which would morph to it, {}, {} "
                    "and {}; a morph "
                    "needs the same topology",
                    name, shape.positions.size(), shape.triangles.size(), shape.edges.size(), base.name,
                    base.positions.size(), base.triangles.size(), base.edges.size()));
  const auto other = std::ranges::mismatch(shape.triangles, base.triangles);
  if (other.in1 != shape.triangles.end())
    place.fail(
        fmt::format("\"{}\" has as many vertices and triangles as \"{}\", but triangle {} joins others; a morph "
                    "needs the same topology",
                    name, base.name, other.in1 - shape.triangles.begin()));
  if (std::ranges::any_of(base.targets, [&](const MorphTarget& target) { return target.name == name; }))
    place.fail(fmt::format("there are two morph targets \"{}\"; name one: {{ mesh = \"...\", name = \"...\" }}", name));
  MorphTarget target;
  target.name = name;
  target.form = TargetForm::absolute;
  target.positions = shape.positions;
  if (!base.normals.empty()) target.normals = shape.normals;
  if (!base.colors.empty()) target.colors = shape.colors;
  base.targets.push_back(std::move(target));
}

}  // namespace morphcl
