// How far a rendered frame is from an fp64 render of the same shot, where, and why.
//
// Coverage and depth order are compared by what each pixel shows: both renders name an object and its triangle (or
// line). Values are compared where both show the same primitive; their error has two causes, told apart: storage, what
// rounding the exact value to half or float costs alone, and arithmetic, what fp32 computed before it was stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/shown_pixels.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::accuracy {

// What the fp64 render does with vertices: on_grid, snap them to 1/256 pixel as the renderers do, so that only rounding
// differs; true_geometry, leave them, so that the cost of the grid shows too.
enum class Truth { on_grid, true_geometry };

struct Tally {
  std::size_t count = 0, not_finite = 0;
  double largest = 0, squares = 0;
  void add(double error);  // of any sign
  double rms() const;
};

struct ErrorByCause {
  Tally all, storage, arithmetic;
};

struct Differences {
  std::string name;            // of the object; empty for the whole frame
  std::size_t pixels = 0;      // that show it in either render
  std::size_t outline = 0;     // that show it in one render and the background in the other
  std::size_t edge = 0;        // that show another primitive, because coverage differs where primitives meet or overlap
  std::size_t order = 0;       // that show another primitive, because the depths of the two compare differently
  double widest_gap = 0;       // of `order`: how much farther, relative
  ErrorByCause color;          // absolute; every channel counts
  ErrorByCause color_spacing;  // in spacings of half: storage alone costs up to 0.5
  ErrorByCause depth;          // relative
  ErrorByCause depth_spacing;  // in spacings of float
  std::size_t other_color = 0, other_depth = 0;  // pixels that do not store the number nearest to the exact one
};

// What differs at a pixel, as the values of the plane `mask`.
enum class PixelDifference { none = 0, outline = 1, edge = 2, order = 3 };

struct FrameDifference {
  std::int64_t frame = 0;
  Truth truth = Truth::on_grid;
  int width = 0, height = 0;
  bool has_color = false, has_depth = false;  // of the plan
  Differences total;
  std::vector<Differences> objects;  // those that show, in the scene's order
  // Row by row from the top: |rendered - exact| of R, G, B and A; of Z relative, 1 where only one of the renders shows
  // something; PixelDifference. Planes of
  // what the plan has not are 0.
  std::vector<float> red, green, blue, alpha, depth, mask;
  std::vector<char> shown;  // not 0 where either render shows something
};

// Error(usage) when the image has more than 2^26 pixels: the comparison keeps some 100 bytes of each.
void check_comparable(const FramePlan& plan);

// `pixels` is what a renderer made of `plan`, and `shown` reference::shown_pixels(plan). `scene` is what the plan was
// made of; tests give another one to see the difference. Errors: those of check_comparable() and evaluate().
FrameDifference compare_with_fp64(const Scene& scene, const FramePlan& plan, const FrameBuffer& pixels,
                                  const std::vector<reference::ShownPixel>& shown, Truth truth);

}  // namespace morphcl::accuracy
