#include "host/math/exact_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr int limb_bits = 32;

}  // namespace

ExactNumber::ExactNumber(double value) {
  if (value == 0) return;
  if (!std::isfinite(value)) throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
  sign_ = value < 0 ? -1 : 1;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(value), &exponent);
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  lowest_ = exponent >= 0 ? exponent / limb_bits : -((-exponent + limb_bits - 1) / limb_bits);
  const int shift = exponent - lowest_ * limb_bits;  // 0 to 31
  const std::uint64_t low = (mantissa & 0xffffffffu) << shift, high = (mantissa >> limb_bits) << shift;
  const std::uint64_t middle = (low >> limb_bits) + (high & 0xffffffffu);
  limb_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(middle),
           static_cast<std::uint32_t>((high >> limb_bits) + (middle >> limb_bits))};
  trim();
}

void ExactNumber::trim() {
  while (!limb_.empty() && limb_.back() == 0) limb_.pop_back();
  const auto kept = std::find_if(limb_.begin(), limb_.end(), [](std::uint32_t limb) { return limb != 0; });
  lowest_ += static_cast<int>(kept - limb_.begin());
  limb_.erase(limb_.begin(), kept);
  if (limb_.empty()) sign_ = lowest_ = 0;
}

ExactNumber ExactNumber::operator-() const {
  ExactNumber result = *this;
  result.sign_ = -sign_;
  return result;
}

ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b) {
  ExactNumber result;
  result.lowest_ = std::min(a.lowest_, b.lowest_);
  const int highest =
      std::max(a.lowest_ + static_cast<int>(a.limb_.size()), b.lowest_ + static_cast<int>(b.limb_.size()));
  const auto size = static_cast<std::size_t>(highest - result.lowest_ + 1);
  std::vector<std::int64_t> column(size, 0);
  const auto add = [&](const ExactNumber& number, int sign) {
    const auto offset = static_cast<std::size_t>(number.lowest_ - result.lowest_);
    for (std::size_t i = 0; i < number.limb_.size(); ++i) column[offset + i] += sign * std::int64_t{number.limb_[i]};
  };
  add(a, a.sign_);
  add(b, sign_of_b);
  // The sign is that of the highest column that is not 0 after the carries: with carries of a negative number it is -1
  // at the top.
  const auto carried = [&] {
    std::int64_t carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::int64_t value = column[i] + carry;
      carry = value >> limb_bits;
      result.limb_[i] = static_cast<std::uint32_t>(value);
    }
    return carry;
  };
  result.limb_.resize(size);
  result.sign_ = 1;
  if (carried() < 0) {
    for (std::int64_t& value : column) value = -value;
    carried();
    result.sign_ = -1;
  }
  result.trim();
  return result;
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  if (a.sign_ == 0) return b;
  if (b.sign_ == 0) return a;
  return ExactNumber::sum(a, b, b.sign_);
}

ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
  if (a.sign_ == 0) return -b;
  if (b.sign_ == 0) return a;
  return ExactNumber::sum(a, b, -b.sign_);
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber result;
  if (a.sign_ == 0 || b.sign_ == 0) return result;
  result.sign_ = a.sign_ * b.sign_;
  result.lowest_ = a.lowest_ + b.lowest_;
  result.limb_.assign(a.limb_.size() + b.limb_.size(), 0);
  for (std::size_t i = 0; i < a.limb_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.limb_.size(); ++j) {
      carry += std::uint64_t{a.limb_[i]} * b.limb_[j] + result.limb_[i + j];
      result.limb_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= limb_bits;
    }
    result.limb_[i + b.limb_.size()] = static_cast<std::uint32_t>(carry);
  }
  result.trim();
  return result;
}

ExactNumber::Leading ExactNumber::leading() const {
  double fraction = 0;
  const std::size_t count = limb_.size();
  for (std::size_t i = 0; i < 3 && i < count; ++i)
    fraction += std::ldexp(static_cast<double>(limb_[count - 1 - i]), -limb_bits * static_cast<int>(i));
  return {fraction, limb_bits * (lowest_ + static_cast<int>(count) - 1)};
}

double quotient(const ExactNumber& numerator, const ExactNumber& denominator) {
  if (numerator.sign_ == 0) return 0;
  const ExactNumber::Leading top = numerator.leading(), bottom = denominator.leading();
  const int sign = numerator.sign_ * denominator.sign_;
  // Within 5 u, so that `start` below is off by at most 20.
  int exponent = 0;
  const double fraction = std::frexp(top.fraction / bottom.fraction, &exponent);
  exponent += top.exponent - bottom.exponent;  // fraction in [1/2, 1) times 2^exponent
  constexpr int smallest = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
  // The unit of the last place; a quotient that lies next to a power of two may need half of it: quarter units decide.
  const int unit = std::max(exponent - 53, smallest) - 2;
  if (unit > 1100) return sign * std::numeric_limits<double>::infinity();
  const double start = std::floor(std::ldexp(fraction, std::max(exponent - unit, -1)));
  // |numerator| - candidate 2^unit |denominator|
  ExactNumber dividend = numerator, divisor = denominator;
  dividend.sign_ = divisor.sign_ = 1;
  const ExactNumber step =
      ExactNumber(std::ldexp(1.0, unit / 2)) * ExactNumber(std::ldexp(1.0, unit - unit / 2)) * divisor;
  auto whole = static_cast<std::int64_t>(start);
  ExactNumber rest = dividend - ExactNumber(start) * step;
  while (rest.sign() < 0) {
    --whole;
    rest = rest + step;
  }
  while ((rest - step).sign() >= 0) {
    ++whole;
    rest = rest - step;
  }
  // whole <= quotient / 2^unit < whole + 1; a bit below stands for what is left ("sticky"), so that one rounding of the
  // integer is that of the quotient.
  int drop = 0;
  while ((whole >> drop) >= (std::int64_t{1} << 53)) ++drop;
  drop = std::max(drop, smallest - unit);
  const std::int64_t kept = whole >> drop, half = std::int64_t{1} << (drop - 1), below = whole - (kept << drop);
  const bool up = below > half || (below == half && (rest.sign() > 0 || (kept & 1) != 0));
  return sign * std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), unit + drop);
}

double square_root_of_quotient(const ExactNumber& numerator, const ExactNumber& denominator) {
  if (numerator.sign_ == 0) return 0;
  // A power of 2 out of the root: limbs are of 32 bits, so exponents are even.
  const int exponent = numerator.leading().exponent - denominator.leading().exponent;
  ExactNumber scaled = numerator;
  scaled.lowest_ -= exponent / limb_bits;
  return std::ldexp(std::sqrt(quotient(scaled, denominator)), exponent / 2);
}

}  // namespace morphcl
