#include "bench/placements.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace morphcl::bench {

namespace {

// splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  double uniform() { return static_cast<double>(next() >> 40) / (1 << 24); }  // [0, 1)

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_ = 12345;
};

// Turned by a uniform random rotation (Shoemake, Graphics Gems III, 1992).
Placement random_placement(Random& random) {
  Placement placement;
  const double u = random.uniform();
  const double first = 2.0 * std::numbers::pi * random.uniform(), second = 2.0 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1.0 - u), s = std::sqrt(u);
  placement.rotation = glm::dquat(s * std::cos(second), r * std::sin(first), r * std::cos(first), s * std::sin(second));
  placement.scale = 0.1 + 0.3 * random.uniform();
  for (const int axis : {2, 1, 0}) placement.translation[axis] = 40.0 * (random.uniform() - 0.5);
  return placement;
}

enum class Seen { wholly, partly, not_at_all };

// Of the cube's bounding sphere, between the four side planes of the view. The box ends long before the far plane.
Seen seen(const Placement& placement, double aspect) {
  const double radius = std::numbers::sqrt3 * placement.scale;
  const double half_angle_y = fovy_degrees * std::numbers::pi / 360.0;
  const double half_angle_x = std::atan(std::tan(half_angle_y) * aspect);
  const glm::dvec3 centre = placement.translation;
  const double depth = -centre.z;
  // Of the two planes of an axis the nearer one decides.
  const double inside_x = depth * std::sin(half_angle_x) - std::abs(centre.x) * std::cos(half_angle_x);
  const double inside_y = depth * std::sin(half_angle_y) - std::abs(centre.y) * std::cos(half_angle_y);
  const double inside = std::min({inside_x, inside_y, depth - near_plane});
  return inside > radius ? Seen::wholly : inside < -radius ? Seen::not_at_all : Seen::partly;
}

}  // namespace

std::vector<Placement> scattered(int count) {
  std::vector<Placement> placements;
  Random random;
  for (int i = 0; i < count; ++i) placements.push_back(random_placement(random));
  return placements;
}

std::vector<Placement> crowd(int count, double aspect, bool only_in_view) {
  std::vector<Placement> placements;
  Random random;
  for (int i = 0; i < count; ++i) {
    const Seen wanted = i % 100 == 0 ? Seen::wholly : Seen::not_at_all;
    Placement placement = random_placement(random);
    while (seen(placement, aspect) != wanted) placement = random_placement(random);
    if (wanted == Seen::wholly || !only_in_view) placements.push_back(placement);
  }
  return placements;
}

}  // namespace morphcl::bench
