#include "tests/device/test_points.hpp"

#include <cmath>

namespace morphcl::testing {

namespace {

// SplitMix64 (Steele, Lea, Flood 2014).
class Sequence {
 public:
  explicit Sequence(std::uint64_t seed) : state_(seed) {}
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

float draw(Sequence& sequence, Family family) {
  const double value = 2 * sequence.unit() - 1;
  switch (family) {
    case Family::benign:
      return static_cast<float>(value);
    case Family::wide:
      return static_cast<float>(std::ldexp(value, static_cast<int>(40 * sequence.unit()) - 20));
    case Family::cancelling:
      return static_cast<float>(1 + 0x1p-18 * value);
  }
  return 0;
}

}  // namespace

Points make_points(std::size_t count, Family family, std::uint64_t seed) {
  Sequence sequence(seed);
  Points points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points.x[i] = draw(sequence, family);
    points.y[i] = draw(sequence, family);
    points.z[i] = draw(sequence, family);
  }
  return points;
}

AffineRows general_matrix() {
  return {{-0.71f, 0.37f, 1.93f, 3.3f}, {0.11f, -2.9f, 0.83f, -7.1f}, {0.57f, 0.61f, 0.13f, 100.7f}};
}

AffineRows cancelling_matrix() {
  return {{1.1f, -0.7f, -0.4f, 0}, {3.3f, 2.2f, -1.1f, -4.4f}, {-1e3f, 1e3f, 1e-3f, -1e-3f}};
}

ProjectiveRows perspective_matrix() {
  const AffineRows rows = general_matrix();
  return {rows.x, rows.y, rows.z, {0, 0, -1, 0.5f}};
}

}  // namespace morphcl::testing
