// Watkins' scan-line algorithm (1970): row by row, between the ends of what crosses the row.
//
// Surfaces are sorted by their first row; those that a row crosses are active, and each has a span of columns, found
// from its edges anew in exact integers, so that nothing adds up. Between two neighbouring ends of spans lies a sample
// span: there the same surfaces are active. The one that is nearest at its left end and at its right end, by more than
// the errors of depth, is nearest in between; where there is none, surfaces cut each other, or are too close, and the
// span is halved. One pixel is decided by the depths at its centre. A span that starts behind what is seen, and stays
// behind it to its own end, is left out.
//
// Surfaces that are blended take no part: this finds what is opaque.
#pragma once

#include <functional>

#include "host/visibility/shown_rows.hpp"

namespace morphcl::visibility {

struct SampleSpan {
  int y, first, end;     // columns
  std::uint32_t active;  // surfaces in it
  SurfaceId shown;       // no_surface where single pixels were decided
};

struct SpanCounts {
  std::uint64_t lines = 0;   // with active surfaces
  std::uint64_t spans = 0;   // of surfaces
  std::uint64_t hidden = 0;  // of these, left out
  std::uint64_t sample_spans = 0;
  std::uint64_t halved = 0;
  std::uint64_t pixels = 0;       // decided alone
  std::uint64_t comparisons = 0;  // of two depths
  std::uint64_t max_active = 0;   // on one line

  void add(const SpanCounts& other);
};

// The rows of `shown`. `visit`, where there is one, is called for every sample span that was not halved.
SpanCounts scan_lines(const ScreenSurfaces& surfaces, ShownRows& shown,
                      const std::function<void(const SampleSpan&)>& visit = {});

}  // namespace morphcl::visibility
