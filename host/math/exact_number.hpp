// Sums, differences and products of doubles without rounding, of any size: what predicates compute with where their
// floating-point evaluation cannot tell the sign.
//
// A number is sign * sum of limb[i] * 2^(32 (i + lowest)). Limbs of 0 at both ends are left out, so that exponents far
// apart cost what the bits between them cost. Schoolbook multiplication: numbers have 3 to some 200 limbs.
#pragma once

#include <cstdint>
#include <vector>

namespace morphcl {

class ExactNumber {
 public:
  ExactNumber() = default;             // 0
  explicit ExactNumber(double value);  // Error(usage) where it is not finite

  int sign() const { return sign_; }  // -1, 0, 1
  ExactNumber operator-() const;

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  // The double nearest to numerator / denominator, ties to even; infinite from half an ulp beyond the largest double
  // on. The denominator is not 0. A quotient of 0 is +0.
  friend double quotient(const ExactNumber& numerator, const ExactNumber& denominator);

  // Its square root, of a quotient of 0 or more, within 2u also where the quotient is no double.
  friend double square_root_of_quotient(const ExactNumber& numerator, const ExactNumber& denominator);

 private:
  // fraction * 2^exponent, the fraction in [1, 2^32), within 2u. Not of 0.
  struct Leading {
    double fraction;
    int exponent;
  };
  Leading leading() const;
  void trim();

  static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b);

  int sign_ = 0;
  int lowest_ = 0;
  std::vector<std::uint32_t> limb_;
};

}  // namespace morphcl
