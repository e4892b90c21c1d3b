// Light in high precision: ambient light and every light's share by the cosine between normal and direction.
#pragma once

#include <vector>

#include "lab/frame_error/precise_camera.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl::accuracy {

template <class Real>
class PreciseLighting {
 public:
  PreciseLighting(const FrameState& state, const PreciseCamera<Real>& camera) : ambient_(to_real<Real>(state.ambient)) {
    for (const LightState& light : state.lights) {
      const Vector3<Real> vector = to_real<Real>(light.vector);
      const bool point = light.kind == LightKind::point;
      lights_.push_back({point,
                         light.falloff,
                         to_real<Real>(light.color),
                         point ? times_point(camera.world_to_eye, vector) : times_vector(camera.world_to_eye, vector),
                         light.spot.has_value(),
                         {},
                         0,
                         0});
      if (!light.spot) continue;
      Source& spot = lights_.back();
      spot.beam = times_vector(camera.world_to_eye, to_real<Real>(light.spot->beam));
      spot.inner = Real(sin_cos_degrees(light.spot->inner_cone_degrees).cos);
      spot.outer = Real(sin_cos_degrees(light.spot->outer_cone_degrees).cos);
    }
  }

  // Of a surface at `position` of eye space; a normal of any length, 0 0 0: ambient light only.
  Vector3<Real> irradiance(const Vector3<Real>& normal, const Vector3<Real>& position) const {
    using std::sqrt;
    const Vector3<Real> n = unit(normal);
    Vector3<Real> sum = ambient_;
    for (const Source& light : lights_) {
      Vector3<Real> to_light = light.vector;
      Real divisor = 1, share = 1;
      if (light.point) {
        to_light = to_light - position;
        const Real square = dot(to_light, to_light);
        divisor = light.falloff ? Real(square * sqrt(square)) : Real(sqrt(square));
        if (light.has_cone && square > 0) share = light.share(Real(-dot(light.beam, to_light) / sqrt(square)));
      }
      const Real cosine = dot(n, to_light);
      if (cosine > 0 && divisor > 0) sum = sum + light.color * Real(share * cosine / divisor);
    }
    return sum;
  }

 private:
  struct Source {
    bool point, falloff;
    Vector3<Real> color, vector;  // eye space: unit direction towards the light, or position
    bool has_cone;
    Vector3<Real> beam;
    Real inner, outer;  // cosines of the cones

    Real share(const Real& cosine) const {
      const Real ramp = (cosine - outer) / (inner - outer);
      if (!(ramp > 0)) return 0;
      return ramp > 1 ? Real(1) : Real(ramp * ramp);
    }
  };
  Vector3<Real> ambient_;
  std::vector<Source> lights_;
};

}  // namespace morphcl::accuracy
