// Points in other than Cartesian coordinates.
#pragma once

#include <glm/glm.hpp>

#include "host/scene/shot/shot_value.hpp"

namespace morphcl {

// A table with one of these keys; angles are degrees, exact at multiples of 90, and y is up:
//   cylindrical = [radius, azimuth, height]  (r sin a, h, r cos a): from +z, 0, towards +x, 90, as cameras count it
//   spherical = [radius, azimuth, polar]     (r sin p sin a, r cos p, r sin p cos a): p from +y, 0, to -y, 180
//   polar = [radius, angle]                  (r cos a, r sin a, 0): in the xy plane from +x, 0, towards +y, 90
// Each coordinate is within 3u64 of the exact one. Error(bad_input) at what is wrong: another key, or several, or a
// list of another length. A radius may be negative.
glm::dvec3 read_coordinates(const ShotValue& table);

}  // namespace morphcl
