// Warnock's algorithm (1969): a window is divided in four until what it shows is simple.
//
// The root is a square of 2^k pixels; windows are half-open and whole pixels, so they never lose or share one. A
// surface lies outside of a window, crosses it (or is within), or surrounds it. A window is simple when nothing is in
// it, when one surface alone is, or when a surface that surrounds it hides all others; a window of one pixel is decided
// by the depths at its centre. What is outside or hidden is not handed down.
//
// Surfaces that are blended take no part: this finds what is opaque.
#pragma once

#include <functional>

#include "host/visibility/shown_rows.hpp"

namespace morphcl::visibility {

// Why a window is not divided further.
enum class WindowCase : std::uint8_t { divided, empty, single, surrounded, pixel };

struct Window {
  int x, y, size;
  WindowCase ended;
  std::uint32_t outside, crossing, surrounding, hidden;  // surfaces that came from the window around it
};

struct WindowCounts {
  std::uint64_t windows[5] = {};    // by WindowCase
  std::uint64_t relations[3] = {};  // by WindowRelation: surfaces compared with windows
  std::uint64_t hidden = 0;         // surfaces dropped behind one that surrounds the window
  std::uint64_t depths = 0;         // comparisons of two surfaces
  int max_depth = 0;
};

// All rows of the picture. `visit`, where there is one, is called for every window, a window before its parts.
WindowCounts subdivide(const ScreenSurfaces& surfaces, ShownRows& shown,
                       const std::function<void(const Window&)>& visit = {});

}  // namespace morphcl::visibility
