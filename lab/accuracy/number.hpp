// Numbers of the reference: binary floating point with far more digits than what is measured.
//
// Wide has 168 bits: 53 of a double, 53 of the cancellation in a difference of products of doubles, and 62 to spare.
// Doubled has twice as many; the report computes every figure with both and compares what it prints.
//
// Arithmetic and functions are those of Boost.Multiprecision's cpp_bin_float, rounded to nearest. They are compiled
// once, in number.cpp: as templates in every operation they would take most of the build's time.
#pragma once

#include <cmath>
#include <cstddef>

namespace morphcl::accuracy {

template <unsigned Bits>
class BinaryFloat {
 public:
  BinaryFloat() : BinaryFloat(0) {}
  BinaryFloat(double value);  // NOLINT: exact
  BinaryFloat(int value);     // NOLINT: exact
  BinaryFloat(const BinaryFloat& other);
  BinaryFloat& operator=(const BinaryFloat& other);
  explicit operator double() const;  // nearest

  BinaryFloat& operator+=(const BinaryFloat& b);
  BinaryFloat& operator-=(const BinaryFloat& b);
  BinaryFloat& operator*=(const BinaryFloat& b);
  BinaryFloat& operator/=(const BinaryFloat& b);
  BinaryFloat operator-() const { return BinaryFloat(0) -= *this; }

  friend BinaryFloat operator+(BinaryFloat a, const BinaryFloat& b) { return a += b; }
  friend BinaryFloat operator-(BinaryFloat a, const BinaryFloat& b) { return a -= b; }
  friend BinaryFloat operator*(BinaryFloat a, const BinaryFloat& b) { return a *= b; }
  friend BinaryFloat operator/(BinaryFloat a, const BinaryFloat& b) { return a /= b; }
  friend bool operator==(const BinaryFloat& a, const BinaryFloat& b) { return a.compare(b) == 0; }
  friend bool operator<(const BinaryFloat& a, const BinaryFloat& b) { return a.compare(b) < 0; }
  friend bool operator>(const BinaryFloat& a, const BinaryFloat& b) { return a.compare(b) > 0; }
  friend bool operator<=(const BinaryFloat& a, const BinaryFloat& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const BinaryFloat& a, const BinaryFloat& b) { return a.compare(b) >= 0; }

  // Boost's number, which number.cpp alone knows, lies in these bytes.
  void* storage() { return bytes_; }
  const void* storage() const { return bytes_; }
  static constexpr std::size_t storage_bytes = Bits / 4 + 64;

 private:
  int compare(const BinaryFloat& b) const;

  alignas(16) std::byte bytes_[storage_bytes];
};

template <unsigned Bits>
BinaryFloat<Bits> abs(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> sqrt(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> sin(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> cos(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> sinh(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> cosh(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> exp(const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> atan2(const BinaryFloat<Bits>& y, const BinaryFloat<Bits>& x);
template <unsigned Bits>
BinaryFloat<Bits> ldexp(const BinaryFloat<Bits>& x, int exponent);

constexpr unsigned wide_bits = 168, doubled_bits = 336;
using Wide = BinaryFloat<wide_bits>;
using Doubled = BinaryFloat<doubled_bits>;

// Number is Wide or Doubled.
template <class Number>
const Number& pi() {
  static const Number value = 4 * atan2(Number(1), Number(1));
  return value;
}

template <class Number>
struct ExactSinCos {
  Number sin, cos;
};

// Exactly 0 and +-1 at multiples of 90 degrees: the angle is reduced in degrees, without an error.
template <class Number>
ExactSinCos<Number> exact_sin_cos(double degrees) {
  int quarters = 0;
  const Number rest = pi<Number>() * std::remquo(degrees, 90.0, &quarters) / 180;
  const Number s = sin(rest), c = cos(rest);
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace morphcl::accuracy
