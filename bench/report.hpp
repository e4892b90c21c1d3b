// What a compared program prints: how long its frames took, and two figures of the last frame by which the pictures of
// different programs are compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "bench/options.hpp"
#include "bench/scenes.hpp"

namespace morphcl::bench {

// A frame before and after what is timed: every buffer exists and every kernel or shader is compiled.
inline constexpr int warm_up_frames = 3;

// Halves in host memory: pixel (x, y) has its red at red[y * row_pitch + x * pixel_step], and so for alpha.
struct PictureView {
  const std::uint16_t *red, *alpha;
  int width, height;
  std::size_t row_pitch, pixel_step;
};

struct PictureFigures {
  long long covered = 0;  // pixels whose alpha is not 0
  double mean_red = 0.0;  // over all pixels
};

PictureFigures picture_figures(const PictureView& picture);

// The two steps of each frame and the whole, in milliseconds; element i is frame i. Processor time counts from when
// this is made to the last frame added, all threads together: unlike the clock's, it does not grow when others use the
// machine.
class FrameTimes {
 public:
  FrameTimes(std::string first_step, std::string second_step)
      : first_step_(std::move(first_step)), second_step_(std::move(second_step)), processor_start_(std::clock()) {}
  void add(double first_ms, double second_ms);

  std::size_t frames() const { return first_ms_.size(); }
  // "STEP_ms" and "frame_ms": medians; "fastest_ms"; "cpu_ms": mean processor time a frame.
  std::vector<std::pair<std::string, double>> summary() const;

 private:
  std::string first_step_, second_step_;
  std::vector<double> first_ms_, second_ms_;
  std::clock_t processor_start_, processor_end_ = processor_start_;
};

// One line of JSON on stdout. `renderer`: the device and version that drew.
void print_report(const std::string& program, const std::string& renderer, const BenchScene& scene,
                  const Options& options, const FrameTimes& times, const PictureFigures& picture);

}  // namespace morphcl::bench
