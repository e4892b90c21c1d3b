#include "tests/rounding/roundings.hpp"

namespace morphcl::test {

void round_pair(double* values) {
  values[0] = static_cast<float>(values[0]);
  values[1] = static_cast<float>(values[1]);
}

void round_triple(double* values) {
  values[0] = static_cast<float>(values[0]);
  values[1] = static_cast<float>(values[1]);
  values[2] = static_cast<float>(values[2]);
}

void round_four(double* values) {
  for (int i = 0; i < 4; ++i) values[i] = static_cast<float>(values[i]);
}

void round_eight(double* values) {
  for (int i = 0; i < 8; ++i) values[i] = static_cast<float>(values[i]);
}

void round_all(double* values, int count) {
  for (int i = 0; i < count; ++i) values[i] = static_cast<float>(values[i]);
}

void scale_pair(double* rounded, const double* values) {
  const double x = 1.5 * values[0], y = 1.5 * values[1];
  rounded[0] = static_cast<float>(x);
  rounded[1] = static_cast<float>(y);
}

void split_pair(double* high, double* low, const double* values) {
  const double x = values[0], y = values[1];
  high[0] = static_cast<float>(x);
  high[1] = static_cast<float>(y);
  low[0] = x - static_cast<double>(static_cast<float>(x));
  low[1] = y - static_cast<double>(static_cast<float>(y));
}

void add_stored(glm::dvec3& sum, const glm::dvec3& direction) { sum += glm::vec3(direction); }

}  // namespace morphcl::test
