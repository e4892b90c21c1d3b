#include "lab/accuracy/figures.hpp"

#include <fmt/core.h>

#include <cmath>

namespace morphcl::accuracy {

const MeasureText& text_of(Measure measure) {
  static const std::array<MeasureText, measure_count> texts = {{
      {"max_ulp", "max ulp", "largest error (ulp)"},
      {"rms_ulp", "rms ulp", "rms error (ulp)"},
      {"max_scaled", "scaled", "largest error / (u sum |terms|)"},
      {"max_absolute", "max abs", "largest error"},
      {"rms_absolute", "rms abs", "rms error"},
      {"max_pixels", "pixels", "largest error (pixels)"},
      {"max_true", "vs true", "largest error against unrounded inputs"},
      {"wrong_per_million", "wrong/M", "wrong decisions a million"},
      {"holes_per_million", "holes/M", "holes a million"},
      {"double_hits_per_million", "twice/M", "double hits a million"},
      {"ties_per_million", "ties/M", "ties a million pairs"},
      {"inversions_per_million", "invers/M", "inversions a million pairs"},
      {"not_finite", "NaN/inf", "results not finite"},
  }};
  return texts[static_cast<std::size_t>(measure)];
}

std::string printed(double figure) { return std::isnan(figure) ? "" : fmt::format("{:.3g}", figure); }

bool same_digits(const Figures& a, const Figures& b) {
  for (std::size_t m = 0; m < measure_count; ++m)
    if (printed(a[static_cast<Measure>(m)]) != printed(b[static_cast<Measure>(m)])) return false;
  return true;
}

}  // namespace morphcl::accuracy
