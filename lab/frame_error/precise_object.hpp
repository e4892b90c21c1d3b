// One object of a frame in high precision: its vertices morphed (p + w d, or p + w (b - p)) and transformed by
// matrices that were never rounded to fp32. Stored positions, normals and colours are fp32 and taken as exact, and so
// is the shape of an elastic object, whose motion is computed in fp64 and rounded once.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/scene/model/base_color.hpp"
#include "lab/frame_error/precise_camera.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl::accuracy {

template <class Real>
struct PreciseVertex {
  Vector3<Real> position;  // morphed, object space
  Real x, y, w, distance;  // clip space; distance along the view axis
  Vector3<Real> normal;    // unit, eye space, outwards; 0 0 0 where the normals vanish. Of smooth objects.
  Vector3<Real> color;     // within [0, 1]. Of objects with vertex colours.
};

template <class Real>
struct PreciseObject {
  const Mesh* mesh = nullptr;
  bool drawn = false;  // visible, and there is something to draw
  Shading shading = Shading::unlit;
  bool lit_per_pixel = false;  // flat: at each pixel, not at the middle of the face
  bool double_sided = false, mirrored = false, has_colors = false;
  Vector3<Real> base_color;
  Matrix<Real> object_to_eye;
  Matrix<Real> normal_to_eye;  // but for a positive factor; row and column 3 are 0
  std::vector<PreciseVertex<Real>> vertices;
  std::vector<glm::uvec2> edges;  // of a wireframe

  std::size_t primitives() const { return shading == Shading::wireframe ? edges.size() : mesh->triangles.size(); }
};

// Cofactors times the sign of the determinant: the inverse transpose but for a positive factor, which exists for
// singular maps too. The matrix is scaled by its largest entry first.
template <class Real>
Matrix<Real> normals_matrix(const Matrix<Real>& m) {
  using std::abs;
  Real largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (abs(m[row][column]) > largest) largest = abs(m[row][column]);
  if (!(largest > 0)) largest = 1;
  Vector3<Real> rows[3];
  for (int row = 0; row < 3; ++row) rows[row] = {m[row][0] / largest, m[row][1] / largest, m[row][2] / largest};
  Matrix<Real> normals{};
  const Real outward = dot(rows[0], cross(rows[1], rows[2])) < 0 ? -1 : 1;
  for (int row = 0; row < 3; ++row) {
    const Vector3<Real> cofactors = cross(rows[(row + 1) % 3], rows[(row + 2) % 3]) * outward;
    normals[row] = {cofactors.x, cofactors.y, cofactors.z, Real(0)};
  }
  return normals;
}

template <class Real, class Stored>
Vector3<Real> morphed(const Mesh& mesh, const std::vector<Stored>& base, std::vector<Stored> MorphTarget::* attribute,
                      const std::vector<double>& weights, std::size_t vertex) {
  const Vector3<Real> start = to_real<Real>(base[vertex]);
  Vector3<Real> value = start;
  for (std::size_t target = 0; target < weights.size(); ++target) {
    const std::vector<Stored>& moved = mesh.targets[target].*attribute;
    if (moved.empty() || weights[target] == 0) continue;
    Vector3<Real> step = to_real<Real>(moved[vertex]);
    if (mesh.targets[target].form == TargetForm::absolute) step = step - start;
    value = value + step * Real(weights[target]);
  }
  return value;
}

template <class Real>
PreciseVertex<Real> make_vertex(const PreciseObject<Real>& object, const Matrix<Real>& object_to_clip,
                                const std::vector<double>& weights, const std::vector<glm::vec3>* shape,
                                std::size_t i) {
  const Mesh& mesh = *object.mesh;
  PreciseVertex<Real> v{};
  v.position =
      shape ? to_real<Real>((*shape)[i]) : morphed<Real>(mesh, mesh.positions, &MorphTarget::positions, weights, i);
  v.x = row_times_point(object_to_clip[0], v.position);
  v.y = row_times_point(object_to_clip[1], v.position);
  v.w = row_times_point(object_to_clip[3], v.position);
  v.distance = -row_times_point(object.object_to_eye[2], v.position);
  if (object.shading == Shading::smooth) {
    Vector3<Real> normal = morphed<Real>(mesh, mesh.normals, &MorphTarget::normals, weights, i);
    if (!(dot(normal, normal) >= Real(0x1p-20))) normal = to_real<Real>(mesh.normals[i]);
    v.normal = unit(times_vector(object.normal_to_eye, normal));
  }
  if (object.has_colors) {
    const Vector3<Real> color = morphed<Real>(mesh, mesh.colors, &MorphTarget::colors, weights, i);
    const auto clamped = [](const Real& c) -> Real { return c < 0 ? Real(0) : c > 1 ? Real(1) : c; };
    v.color = {clamped(color.x), clamped(color.y), clamped(color.z)};
  }
  return v;
}

// Object `index` of the scene at this state of its timeline; `shape`: the positions of an elastic one, else null.
template <class Real>
PreciseObject<Real> make_object(const Scene& scene, std::size_t index, const FrameState& state,
                                const PreciseCamera<Real>& camera, const std::vector<glm::vec3>* shape) {
  const Object& source = scene.objects[index];
  PreciseObject<Real> object;
  object.mesh = &scene.meshes[source.mesh];
  object.shading = source.material.shading;
  object.lit_per_pixel = object.shading == Shading::smooth && object.mesh->normals.empty();
  if (object.lit_per_pixel) object.shading = Shading::flat;
  if (object.shading == Shading::wireframe) object.edges = wireframe_edges(*object.mesh);
  object.drawn = state.node_visible[source.node] != 0 && object.primitives() > 0;
  if (!object.drawn) return object;
  object.double_sided = source.material.double_sided;
  object.has_colors = object.shading != Shading::wireframe && !object.mesh->colors.empty();
  object.base_color = to_real<Real>(base_color_at(source.material, scene.timeline.time.frame_ticks(state.frame)));
  object.object_to_eye = camera.world_to_eye * to_real<Real>(state.node_to_world[source.node]);
  object.normal_to_eye = normals_matrix(object.object_to_eye);
  const Matrix<Real>& m = object.object_to_eye;
  const auto row = [&](int r) -> Vector3<Real> { return {m[r][0], m[r][1], m[r][2]}; };
  object.mirrored = dot(row(0), cross(row(1), row(2))) < 0;
  const Matrix<Real> object_to_clip = camera.eye_to_clip * object.object_to_eye;
  const std::vector<double> weights = weights_at(source.morph, scene.timeline.time, state.frame);
  for (std::size_t i = 0; i < object.mesh->positions.size(); ++i)
    object.vertices.push_back(make_vertex(object, object_to_clip, weights, shape, i));
  return object;
}

}  // namespace morphcl::accuracy
