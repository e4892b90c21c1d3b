// A frame's colours made brighter or darker on their way to a picture of whole codes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

namespace morphcl {

// 2^stops, |stops| at most 1000. The same bits on every machine: whole stops are exact, others within an ulp.
double exposure_gain(double stops);

// The tables of srgb.hpp for values times a gain: copies are cheap, they share them.
class Exposure {
 public:
  explicit Exposure(double stops = 0);

  double gain() const { return gain_; }
  // By the half's bits: the correctly rounded code of the value times gain(), clamped to [0, 1]; NaN is 0.
  const std::array<std::uint8_t, 65536>& srgb8() const { return *srgb8_; }
  const std::array<std::uint16_t, 65536>& srgb16() const { return *srgb16_; }

 private:
  double gain_;
  std::shared_ptr<const std::array<std::uint8_t, 65536>> srgb8_;
  std::shared_ptr<const std::array<std::uint16_t, 65536>> srgb16_;
};

}  // namespace morphcl
