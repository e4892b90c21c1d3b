// Numbers by planes: one array for each input or result of an operation, all as long as the batch.
#pragma once

#include <cstddef>
#include <vector>

namespace morphcl::accuracy {

template <class Real>
class Planes {
 public:
  Planes() = default;
  Planes(std::size_t planes, std::size_t count) : planes_(planes), count_(count), values_(planes * count) {}

  std::size_t planes() const { return planes_; }
  std::size_t size() const { return count_; }  // elements a plane
  Real* plane(std::size_t p) { return values_.data() + p * count_; }
  const Real* plane(std::size_t p) const { return values_.data() + p * count_; }
  std::vector<Real>& values() { return values_; }  // plane after plane
  const std::vector<Real>& values() const { return values_; }

 private:
  std::size_t planes_ = 0, count_ = 0;
  std::vector<Real> values_;
};

// What an operation computes with: the numbers that are meant, and those that binary32 storage leaves of them. Those
// that all elements share are exact in both.
struct Batch {
  Planes<double> truth;
  Planes<float> stored;
  std::vector<double> constants;

  std::size_t size() const { return truth.size(); }
};

template <class To, class From>
Planes<To> converted(const Planes<From>& from) {
  Planes<To> to(from.planes(), from.size());
  for (std::size_t i = 0; i < from.values().size(); ++i) to.values()[i] = static_cast<To>(from.values()[i]);
  return to;
}

}  // namespace morphcl::accuracy
