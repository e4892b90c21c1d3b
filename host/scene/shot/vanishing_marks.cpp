#include "host/scene/shot/vanishing_marks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "host/geometry/bounds.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

namespace {

constexpr double half_cross = 0.03;  // of the picture's height
const glm::dvec4 colors[3] = {{0.9, 0.1, 0.1, 1}, {0.1, 0.7, 0.1, 1}, {0.2, 0.4, 1.0, 1}};

Box bounds_of(const Scene& scene, const FrameState& state) {
  Box box;
  for (const Object& object : scene.objects) {
    const auto node = static_cast<std::size_t>(object.node);
    if (!state.node_visible[node]) continue;
    const MorphBounds mesh(scene.meshes[static_cast<std::size_t>(object.mesh)]);
    const std::vector<double> weights = weights_at(object.morph, scene.timeline.time, state.frame);
    box.include(transformed(mesh.at(weights), state.node_to_world[node]));
  }
  return box;
}

struct View {
  glm::dmat3 eye_axes;  // columns: the eye's x, y and z axis in the world
  glm::dvec3 eye;
  double near, far, y_scale;  // of NDC, at distance 1
};

double distance_of(const glm::dvec3& point, const View& view) { return glm::dot(view.eye - point, view.eye_axes[2]); }

// As far as the farthest corner, and between near and far.
double distance_of_marks(const Box& box, const View& view) {
  double farthest = 0;
  for (int i = 0; i < 8; ++i) farthest = std::max(farthest, distance_of(box.corner(i), view));
  return std::clamp(farthest, 1.01 * view.near, std::max(0.99 * view.far, 1.01 * view.near));
}

// `away`: along the axis, away from the viewer; `axis`: its number.
Mesh mark(const Box& box, const View& view, int axis, const glm::dvec3& away) {
  const double distance = distance_of_marks(box, view);
  const glm::dvec3 point = view.eye + distance / -glm::dot(away, view.eye_axes[2]) * away;
  Mesh mesh;
  mesh.name = std::string("vanishing point ") + "xyz"[axis];
  const auto add = [&](const glm::dvec3& p) {
    mesh.positions.push_back(to_fp32(p));
    return static_cast<unsigned>(mesh.positions.size() - 1);
  };
  const unsigned end = add(point);
  for (int corner = 0; corner < 8; ++corner) {
    // Of the two ends of an edge along the axis the one on the viewer's side.
    const bool upper = (corner >> axis & 1) != 0;
    if (upper == (away[axis] > 0)) continue;
    mesh.edges.push_back({add(box.corner(corner)), end});
  }
  const double size = half_cross * 2 * distance / view.y_scale;
  for (int direction = 0; direction < 2; ++direction) {
    const glm::dvec3 half = 0.5 * size * view.eye_axes[direction];
    const unsigned first = add(point - half);
    mesh.edges.push_back({first, add(point + half)});
  }
  return mesh;
}

void add_object(Mesh mesh, const glm::dvec4& color, Scene& scene) {
  Object object;
  object.name = mesh.name;
  object.mesh = static_cast<int>(scene.meshes.size());
  object.node = static_cast<int>(scene.timeline.nodes.size());
  object.material = {color, Shading::wireframe, false};
  Node node;
  node.name = mesh.name;
  scene.timeline.nodes.push_back(std::move(node));
  scene.meshes.push_back(std::move(mesh));
  scene.objects.push_back(std::move(object));
}

}  // namespace

bool marks_vanishing_points(const ShotTable& camera_table, const Camera& camera) {
  const auto mark = camera_table.find("mark_vanishing_points");
  if (!mark || !mark->boolean()) return false;
  if (is_parallel(camera.projection)) mark->fail("a parallel projection has no vanishing points");
  if (const auto parent = camera_table.find("parent"))
    parent->fail("vanishing points can be marked for a camera that stands in the world; this one has a parent");
  if (!camera.eye_track.empty() || !camera.target_track.empty() || !camera.up_track.empty())
    mark->fail("vanishing points can be marked for a camera that stands still; this one has tracks");
  return true;
}

void add_vanishing_marks(Scene& scene) {
  const FrameState state = evaluate(scene.timeline, frame_numbers(scene.frames).front());
  const Box box = bounds_of(scene, state);
  if (box.empty()) return;
  const Projection& projection = state.camera.projection;
  const double aspect = static_cast<double>(scene.image.width) / scene.image.height;
  const glm::dmat4& to_eye = state.camera.world_to_eye;
  const glm::dmat3 axes = glm::transpose(glm::dmat3(to_eye));
  const View view{axes, -(axes * glm::dvec3(to_eye[3])), near_distance(projection), far_distance(projection),
                  projection_matrix(projection, aspect)[1][1]};
  const VanishingPoints points = vanishing_points(projection, aspect, to_eye);
  for (int axis = 0; axis < 3; ++axis) {
    if (!points[static_cast<std::size_t>(axis)]) continue;
    glm::dvec3 away(0.0);
    away[axis] = view.eye_axes[2][axis] > 0 ? -1 : 1;
    add_object(mark(box, view, axis, away), colors[axis], scene);
  }
}

}  // namespace morphcl
