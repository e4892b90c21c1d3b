// A sum of products without any rounding, as an expansion of doubles that do not overlap (Shewchuk 1997, grow-expansion
// with zeros left out). Barring overflow and underflow: factors are 0 or of a size between 2^-200 and 2^200.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace morphcl::accuracy {

class ExactSum {
 public:
  // Two integers below 2^53, and a double: four terms. At most six products fit.
  void add_product(std::int64_t a, std::int64_t b, double c) {
    const double product = static_cast<double>(b) * c, rest = std::fma(static_cast<double>(b), c, -product);
    for (const double part : {rest, product}) {
      const double high = static_cast<double>(a) * part;
      add(std::fma(static_cast<double>(a), part, -high));
      add(high);
    }
  }

  // Within 2 units roundoff of the sum, relative; exactly 0 when the sum is.
  template <class Real>
  Real rounded() const {
    Real sum(0);
    for (std::size_t i = 0; i < size_; ++i) sum += Real(part_[i]);
    return sum;
  }

 private:
  void add(double value) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + part_[i], of_part = sum - value;
      const double rest = (value - (sum - of_part)) + (part_[i] - of_part);
      if (rest != 0) part_[kept++] = rest;
      value = sum;
    }
    size_ = kept;
    if (value != 0) part_[size_++] = value;
  }

  std::array<double, 24> part_;  // from small to large
  std::size_t size_ = 0;
};

}  // namespace morphcl::accuracy
