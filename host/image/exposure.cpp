#include "host/image/exposure.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "host/image/srgb.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

// Of a table that lives as long as the program.
template <class Table>
std::shared_ptr<const Table> unowned(const Table& table) {
  return {std::shared_ptr<const Table>(), &table};
}

}  // namespace

double exposure_gain(double stops) {
  const double whole = std::floor(stops), part = stops - whole;
  return std::ldexp(part == 0 ? 1.0 : exponential(part * std::numbers::ln2), static_cast<int>(whole));
}

Exposure::Exposure(double stops) : gain_(exposure_gain(stops)) {
  if (gain_ == 1) {
    srgb8_ = unowned(srgb8_from_half());
    srgb16_ = unowned(srgb16_from_half());
    return;
  }
  auto wide = std::make_shared<std::array<std::uint16_t, 65536>>();
  auto narrow = std::make_shared<std::array<std::uint8_t, 65536>>();
  for (std::size_t bits = 0; bits < wide->size(); ++bits) {
    (*wide)[bits] = srgb16_of(gain_ * displayable_from_half()[bits]);
    (*narrow)[bits] = srgb8_from_srgb16((*wide)[bits]);
  }
  srgb8_ = std::move(narrow);
  srgb16_ = std::move(wide);
}

}  // namespace morphcl
