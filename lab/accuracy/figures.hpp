// What is measured of a variant, and how it is written.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>

namespace morphcl::accuracy {

enum class Measure {
  max_ulp,  // units in the last place of the exact result
  rms_ulp,
  max_scaled,    // |error| / (u * sum of the absolute terms): 1 is one rounding of well-conditioned sums
  max_absolute,  // in the results' own unit
  rms_absolute,
  max_pixels,   // on the screen that the family names, against the exact results for inputs as binary32
  max_true,     // absolute, against what the inputs were before they were stored
  wrong,        // per million elements: decisions that differ from the exact one
  holes,        // per million: hit by neither of two triangles that share an edge
  double_hits,  // per million: hit by both
  ties,         // per million pairs of depths: equal where they should differ
  inversions,   // per million pairs: in the wrong order
  not_finite,   // NaN or infinite results, counted
};
constexpr std::size_t measure_count = 13;

struct MeasureText {
  const char* name;   // of CSV columns and JSON fields
  const char* title;  // of table columns
  const char* axis;   // of plots
};
const MeasureText& text_of(Measure measure);

// One number a measure; NaN where a measure does not apply.
class Figures {
 public:
  Figures() { values_.fill(std::numeric_limits<double>::quiet_NaN()); }
  double& operator[](Measure measure) { return values_[static_cast<std::size_t>(measure)]; }
  double operator[](Measure measure) const { return values_[static_cast<std::size_t>(measure)]; }
  bool has(Measure measure) const { return (*this)[measure] == (*this)[measure]; }

 private:
  std::array<double, measure_count> values_;
};

// As it is printed everywhere: three significant digits; "" where a measure does not apply.
std::string printed(double figure);

// Whether every figure is printed the same.
bool same_digits(const Figures& a, const Figures& b);

}  // namespace morphcl::accuracy
