// What a compared program prints: how long its frames took, and two figures of the last frame by which the pictures of
// different programs are compared.
#pragma once

#include <chrono>
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

// The steps of each frame in milliseconds of the clock. Processor time counts from when this is made to the last frame
// finished, all threads together: unlike the clock's, it does not grow when others use the machine.
class FrameTimes {
 public:
  explicit FrameTimes(std::vector<std::string> steps);

  void start_frame();
  void finish_step();  // of those named, the next one; the last one finishes the frame

  std::size_t frames() const { return whole_ms_.size(); }
  // "STEP_ms" and "frame_ms": medians; "fastest_ms"; "cpu_ms": mean processor time a frame. At least one frame
  // finished.
  std::vector<std::pair<std::string, double>> summary() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::vector<std::string> steps_;
  std::vector<std::vector<double>> step_ms_;  // [step][frame]
  std::vector<double> whole_ms_;
  std::size_t step_ = 0;
  Clock::time_point frame_start_{}, step_start_{};
  std::clock_t processor_start_ = std::clock(), processor_end_ = processor_start_;
};

// What was drawn.
struct SceneFigures {
  std::string name;
  int width, height;
  std::size_t objects, vertices, triangles;  // vertices and triangles of all objects together
  double scene_ms = 0;                       // what making its arrays and fitting its camera took; 0: not measured
};

SceneFigures scene_figures(const BenchScene& scene);

// One line of JSON on stdout. `renderer`: the device and version that drew.
void print_report(const std::string& program, const std::string& renderer, const SceneFigures& scene, int threads,
                  const FrameTimes& times, const PictureFigures& picture);

}  // namespace morphcl::bench
