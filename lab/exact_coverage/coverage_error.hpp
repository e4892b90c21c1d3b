// What 1, 2, 4, 8 and 16 samples a pixel miss of the exact coverage of a frame.
//
// A pixel is an edge pixel when more than one surface has a part in it. There the error of a surface is the share of
// the samples that show it less the share of the pixel that it has; the errors of a pixel's surfaces add up to 0. What
// counts as a surface is told in three ways: everything that is drawn as one, objects, triangles; nothing drawn is a
// surface in all three.
//
// Bias and spread: samples whose mean is not the pixel's centre show the picture moved. `shift_x` and `shift_y` are the
// movement that explains most of the errors (least squares, by the exact derivatives of the areas); what is left then
// is the spread.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <string>

#include "lab/exact_coverage/exact_coverage.hpp"
#include "morphcl/scene.hpp"

namespace morphcl::accuracy {

enum class Surfaces { all, objects, triangles };
constexpr std::size_t surfaces_count = 3;
const char* name_of(Surfaces surfaces);  // "all", "objects", "triangles"

class CoverageTally {
 public:
  // One surface of an edge pixel: its error, and how its area grows with a movement of the picture.
  void add(double error, double with_x, double with_y);
  void end_pixel();
  void add_bias(double error) { bias_ += error; }  // of what is drawn against nothing drawn
  CoverageTally& operator+=(const CoverageTally& other);

  std::size_t edge_pixels() const { return pixels_; }
  double largest() const { return largest_; }  // error of a surface in a pixel
  double rms() const;  // of a pixel's error, the root of half the sum of squares: |error| where two surfaces meet
  double beyond() const { return pixels_ == 0 ? 0 : static_cast<double>(beyond_) / static_cast<double>(pixels_); }
  double bias() const { return pixels_ == 0 ? 0 : bias_ / static_cast<double>(pixels_); }  // mean, of Surfaces::all
  std::array<double, 2> shift() const;                                                     // pixels, right and down
  double spread() const;                                                                   // rms once it is moved back

  static constexpr double limit = 1.0 / 255;  // of `beyond`: a step of 8 bits

 private:
  std::size_t pixels_ = 0, beyond_ = 0;
  double largest_ = 0, squares_ = 0, bias_ = 0;
  double xx_ = 0, xy_ = 0, yy_ = 0, error_x_ = 0, error_y_ = 0;  // halves of sums over surfaces
  double largest_of_pixel_ = 0;
};

// `of[surfaces][samples]`: samples by their place in sample_counts.
struct CoverageError {
  std::int64_t frame = 0;
  int width = 0, height = 0;
  std::size_t pixels = 0;  // that show something
  std::array<std::array<CoverageTally, sample_counts.size()>, surfaces_count> of;
  // Samples that show a triangle which has no area in their pixel: on an edge, or where fp32 orders depths otherwise.
  std::array<std::size_t, sample_counts.size()> strays{};
  double error_bound = 0;  // of exact areas, the largest of a pixel

  const CoverageTally& tally(Surfaces surfaces, std::size_t count) const {
    return of[static_cast<std::size_t>(surfaces)][count];
  }
  // Of another frame, or of other rows.
  CoverageError& operator+=(const CoverageError& other);
};

struct CoverageWork {
  int threads = 1;
  std::function<void(int done, int all)> progress;  // of parts of the picture, one call at a time; may be empty
  const std::atomic<bool>* stop = nullptr;          // set: Error(interrupted)
};

// The plan that coverage is measured by: colour, as many samples as there are, and opaque surfaces, whatever the scene
// says.
Scene scene_for_coverage(Scene scene);

// `plan` is one of scene_for_coverage(). The same numbers for any number of threads. Errors: those of ExactCoverage.
CoverageError coverage_error(const FramePlan& plan, const CoverageWork& work = {});

// One line for the header; one for each kind of surface and number of samples of a frame.
std::string coverage_csv_header();
std::string coverage_csv_lines(const CoverageError& error);

}  // namespace morphcl::accuracy
