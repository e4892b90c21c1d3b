#include "lab/accuracy/number.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <new>

namespace morphcl::accuracy {

namespace {

template <unsigned Bits>
using Boost = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<Bits, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

template <unsigned Bits>
Boost<Bits>& in(BinaryFloat<Bits>& x) {
  return *std::launder(static_cast<Boost<Bits>*>(x.storage()));
}

template <unsigned Bits>
const Boost<Bits>& in(const BinaryFloat<Bits>& x) {
  return *std::launder(static_cast<const Boost<Bits>*>(x.storage()));
}

template <unsigned Bits>
BinaryFloat<Bits> out(const Boost<Bits>& value) {
  BinaryFloat<Bits> x;
  in(x) = value;
  return x;
}

}  // namespace

template <unsigned Bits>
BinaryFloat<Bits>::BinaryFloat(double value) {
  static_assert(sizeof(Boost<Bits>) <= storage_bytes && alignof(Boost<Bits>) <= 16);
  static_assert(std::is_trivially_destructible_v<Boost<Bits>>);
  new (storage()) Boost<Bits>(value);
}

template <unsigned Bits>
BinaryFloat<Bits>::BinaryFloat(int value) {
  new (storage()) Boost<Bits>(value);
}

template <unsigned Bits>
BinaryFloat<Bits>::BinaryFloat(const BinaryFloat& other) {
  new (storage()) Boost<Bits>(in(other));
}

template <unsigned Bits>
BinaryFloat<Bits>& BinaryFloat<Bits>::operator=(const BinaryFloat& other) {
  if (this != &other) in(*this) = in(other);
  return *this;
}

template <unsigned Bits>
BinaryFloat<Bits>::operator double() const {
  return in(*this).template convert_to<double>();
}

template <unsigned Bits>
BinaryFloat<Bits>& BinaryFloat<Bits>::operator+=(const BinaryFloat& b) {
  in(*this) += in(b);
  return *this;
}

template <unsigned Bits>
BinaryFloat<Bits>& BinaryFloat<Bits>::operator-=(const BinaryFloat& b) {
  in(*this) -= in(b);
  return *this;
}

template <unsigned Bits>
BinaryFloat<Bits>& BinaryFloat<Bits>::operator*=(const BinaryFloat& b) {
  in(*this) *= in(b);
  return *this;
}

template <unsigned Bits>
BinaryFloat<Bits>& BinaryFloat<Bits>::operator/=(const BinaryFloat& b) {
  in(*this) /= in(b);
  return *this;
}

template <unsigned Bits>
int BinaryFloat<Bits>::compare(const BinaryFloat& b) const {
  return in(*this).compare(in(b));
}

template <unsigned Bits>
BinaryFloat<Bits> abs(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(abs(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> sqrt(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(sqrt(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> sin(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(sin(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> cos(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(cos(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> sinh(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(sinh(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> cosh(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(cosh(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> exp(const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(exp(in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> atan2(const BinaryFloat<Bits>& y, const BinaryFloat<Bits>& x) {
  return out(Boost<Bits>(atan2(in(y), in(x))));
}

template <unsigned Bits>
BinaryFloat<Bits> ldexp(const BinaryFloat<Bits>& x, int exponent) {
  return out(Boost<Bits>(ldexp(in(x), exponent)));
}

#define INSTANTIATE(BITS)                                                               \
  template class BinaryFloat<BITS>;                                                     \
  template BinaryFloat<BITS> abs(const BinaryFloat<BITS>&);                             \
  template BinaryFloat<BITS> sqrt(const BinaryFloat<BITS>&);                            \
  template BinaryFloat<BITS> sin(const BinaryFloat<BITS>&);                             \
  template BinaryFloat<BITS> cos(const BinaryFloat<BITS>&);                             \
  template BinaryFloat<BITS> sinh(const BinaryFloat<BITS>&);                            \
  template BinaryFloat<BITS> cosh(const BinaryFloat<BITS>&);                            \
  template BinaryFloat<BITS> exp(const BinaryFloat<BITS>&);                             \
  template BinaryFloat<BITS> atan2(const BinaryFloat<BITS>&, const BinaryFloat<BITS>&); \
  template BinaryFloat<BITS> ldexp(const BinaryFloat<BITS>&, int);
INSTANTIATE(wide_bits)
INSTANTIATE(doubled_bits)
#undef INSTANTIATE

}  // namespace morphcl::accuracy
