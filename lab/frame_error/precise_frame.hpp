// A frame drawn in high precision by plain loops: the judge of what the renderers' fp32 changes.
//
// It shares no arithmetic with them: only the scene, the timeline's state (fp64) and the projection's matrix. What a
// frame means is the same: morph, transform, clip, cover by the top-left rule, the nearest primitive wins and of equals
// the first, light by face or by interpolated normal, colours interpolated in perspective. Geometry says whether
// vertices are snapped to the sub-pixel grid (OnGrid<Real>) or stay where they are (TrueGeometry<Real>).
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "lab/frame_error/precise_light.hpp"
#include "lab/frame_error/precise_object.hpp"
#include "lab/frame_error/screen_line.hpp"

namespace morphcl::accuracy {

constexpr std::uint32_t no_object = 0xffffffff;

using ElasticShapesOfFrame = std::map<std::uint32_t, const std::vector<glm::vec3>*>;

// What a pixel shows: a triangle, or an edge of a wireframe, of an object of the scene.
template <class Real>
struct Visible {
  Real distance{0};
  std::uint32_t object = no_object, primitive = 0;
};

template <class Geometry>
class PreciseFrame {
 public:
  using Real = typename Geometry::Real;

  // `scene` is valid and outlives the frame. `shapes`: the positions of elastic objects by their index, which outlive
  // it too. Errors: those of evaluate().
  PreciseFrame(const Scene& scene, std::int64_t frame, const ElasticShapesOfFrame& shapes = {})
      : PreciseFrame(scene, evaluate(scene.timeline, frame), shapes) {}
  PreciseFrame(const Scene& scene, const FrameState& state, const ElasticShapesOfFrame& shapes)
      : camera_(state.camera, scene.image.width, scene.image.height), lighting_(state, camera_) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const auto shape = shapes.find(static_cast<std::uint32_t>(i));
      objects_.push_back(make_object(scene, i, state, camera_, shape == shapes.end() ? nullptr : shape->second));
    }
  }
  PreciseFrame(const PreciseFrame&) = delete;
  PreciseFrame& operator=(const PreciseFrame&) = delete;

  const PreciseCamera<Real>& camera() const { return camera_; }
  const std::vector<PreciseObject<Real>>& objects() const { return objects_; }

  // One a pixel, row by row from the top.
  std::vector<Visible<Real>> find_visible() const {
    std::vector<Visible<Real>> nearest(static_cast<std::size_t>(camera_.width) * camera_.height);
    for (std::uint32_t o = 0; o < objects_.size(); ++o) {
      if (!objects_[o].drawn) continue;
      for (std::uint32_t p = 0; p < objects_[o].primitives(); ++p)
        for_each_piece(o, p, [&](const auto& piece) {
          piece.for_each_pixel([&](int x, int y, const Hit<Real>& hit) {
            Visible<Real>& held = nearest[static_cast<std::size_t>(y) * camera_.width + x];
            if (hit.distance <= camera_.far && (held.object == no_object || hit.distance < held.distance))
              held = {hit.distance, o, p};
          });
        });
    }
    return nearest;
  }

  // What a primitive shows at a pixel's centre, whether or not another one is nearer; nothing where it does not cover
  // it.
  std::optional<Hit<Real>> hit(std::uint32_t object, std::uint32_t primitive, int x, int y) const {
    std::optional<Hit<Real>> nearest;
    if (!objects_[object].drawn) return nearest;
    for_each_piece(object, primitive, [&](const auto& piece) {
      const std::optional<Hit<Real>> found = piece.hit(x, y);
      if (found && found->distance <= camera_.far && (!nearest || found->distance < nearest->distance)) nearest = found;
    });
    return nearest;
  }

  // Whether the primitive also covers everything within `reach` sub-pixels of the pixel's centre.
  bool covers_around(std::uint32_t object, std::uint32_t primitive, int x, int y,
                     const typename Geometry::Coordinate& reach) const {
    bool covers = false;
    for_each_piece(object, primitive, [&](const auto& piece) { covers |= piece.covers_around(x, y, reach); });
    return covers;
  }

  // Red, green and blue, not rounded.
  Vector3<Real> color(std::uint32_t object_index, std::uint32_t primitive, const Hit<Real>& hit, int x, int y) const {
    const PreciseObject<Real>& object = objects_[object_index];
    if (object.shading == Shading::wireframe) return object.base_color;
    const glm::uvec3 triangle = object.mesh->triangles[primitive];
    const PreciseVertex<Real>* const v[3] = {&object.vertices[triangle[0]], &object.vertices[triangle[1]],
                                             &object.vertices[triangle[2]]};
    const auto mix = [&](Vector3<Real> PreciseVertex<Real>::* value) {
      return v[0]->*value * hit.weight[0] + v[1]->*value * hit.weight[1] + v[2]->*value * hit.weight[2];
    };
    Vector3<Real> color = object.base_color;
    if (object.shading == Shading::flat) {
      const auto [normal, middle] = face_of(object, *v[0], *v[1], *v[2]);
      color =
          color * lighting_.irradiance(normal, object.lit_per_pixel ? camera_.position(x, y, hit.distance) : middle);
    }
    if (object.shading == Shading::smooth) {
      Vector3<Real> normal = mix(&PreciseVertex<Real>::normal);
      if (object.double_sided && !hit.front) normal = -normal;
      color = color * lighting_.irradiance(normal, camera_.position(x, y, hit.distance));
    }
    return object.has_colors ? color * mix(&PreciseVertex<Real>::color) : color;
  }

 private:
  struct Face {
    Vector3<Real> normal, middle;
  };
  Face face_of(const PreciseObject<Real>& object, const PreciseVertex<Real>& a, const PreciseVertex<Real>& b,
               const PreciseVertex<Real>& c) const {
    const Vector3<Real> face = scaled_to_one(cross(b.position - a.position, c.position - a.position));
    Vector3<Real> normal = scaled_to_one(times_vector(object.normal_to_eye, face));
    const Vector3<Real> middle =
        times_point(object.object_to_eye, (a.position + b.position + c.position) * Real(Real(1) / 3));
    if (object.double_sided && !camera_.is_seen_from_outside(normal, middle)) normal = -normal;
    return {normal, middle};
  }

  // visit(piece) for what clipping leaves of a primitive and culling does not take away.
  template <class Visit>
  void for_each_piece(std::uint32_t object_index, std::uint32_t primitive, const Visit& visit) const {
    const PreciseObject<Real>& object = objects_[object_index];
    const bool lines = object.shading == Shading::wireframe;
    Polygon<Real> polygon;
    for (int i = 0; i < (lines ? 2 : 3); ++i) {
      const PreciseVertex<Real>& v =
          object.vertices[lines ? object.edges[primitive][i] : object.mesh->triangles[primitive][i]];
      if (!is_finite(v)) return;
      polygon.push_back({v.x, v.y, v.w, v.distance, {Real(i == 0), Real(i == 1), Real(i == 2)}});
    }
    const Clipper<Real> clipper(camera_);
    if (lines) {
      polygon = clipper.line(polygon);
      if (polygon.size == 2) visit(ScreenLine<Geometry>(polygon.corner[0], polygon.corner[1], camera_));
      return;
    }
    polygon = clipper.triangle(polygon);
    for (int i = 1; i + 1 < polygon.size; ++i) {
      const auto corner = [&](int at) { return polygon.corner[static_cast<std::size_t>(at)]; };
      const ScreenTriangle<Geometry> piece({corner(0), corner(i), corner(i + 1)}, camera_, object.mirrored);
      if (!piece.empty() && (piece.front() || object.double_sided)) visit(piece);
    }
  }

  static bool is_finite(const PreciseVertex<Real>& v) {
    using std::abs;
    const Real largest = std::numeric_limits<double>::max() / 0x1p20;  // and so are the products of clipping
    return abs(v.x) <= largest && abs(v.y) <= largest && abs(v.w) <= largest && abs(v.distance) <= largest;
  }

  PreciseCamera<Real> camera_;
  PreciseLighting<Real> lighting_;
  std::vector<PreciseObject<Real>> objects_;
};

}  // namespace morphcl::accuracy
