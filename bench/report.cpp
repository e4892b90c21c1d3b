#include "bench/report.hpp"

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace morphcl::bench {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

}  // namespace

PictureFigures picture_figures(const PictureView& picture) {
  PictureFigures figures;
  double sum = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t at =
          static_cast<std::size_t>(y) * picture.row_pitch + static_cast<std::size_t>(x) * picture.pixel_step;
      half red;
      red.setBits(picture.red[at]);
      sum += static_cast<double>(float{red});
      figures.covered += picture.alpha[at] != 0;
    }
  figures.mean_red = sum / (static_cast<double>(picture.width) * picture.height);
  return figures;
}

FrameTimes::FrameTimes(std::vector<std::string> steps) : steps_(std::move(steps)), step_ms_(steps_.size()) {}

void FrameTimes::start_frame() {
  step_ = 0;
  frame_start_ = step_start_ = Clock::now();
}

void FrameTimes::finish_step() {
  const Clock::time_point now = Clock::now();
  const auto milliseconds_since = [now](Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(now - start).count();
  };
  step_ms_[step_++].push_back(milliseconds_since(step_start_));
  step_start_ = now;
  if (step_ < steps_.size()) return;
  whole_ms_.push_back(milliseconds_since(frame_start_));
  processor_end_ = std::clock();
}

std::vector<std::pair<std::string, double>> FrameTimes::summary() const {
  const double processor_ms = 1000.0 * static_cast<double>(processor_end_ - processor_start_) / CLOCKS_PER_SEC;
  std::vector<std::pair<std::string, double>> figures;
  for (std::size_t step = 0; step < steps_.size(); ++step)
    figures.emplace_back(steps_[step] + "_ms", median(step_ms_[step]));
  figures.emplace_back("frame_ms", median(whole_ms_));
  figures.emplace_back("fastest_ms", *std::min_element(whole_ms_.begin(), whole_ms_.end()));
  figures.emplace_back("cpu_ms", processor_ms / static_cast<double>(frames()));
  return figures;
}

SceneFigures scene_figures(const BenchScene& scene) {
  const std::size_t objects = scene.placements.size();
  return {scene.name,
          scene.width,
          scene.height,
          objects,
          objects * scene.shape.positions[0].size(),
          objects * scene.shape.triangles.size(),
          0.0};
}

void print_report(const std::string& program, const std::string& renderer, const SceneFigures& scene, int threads,
                  const FrameTimes& times, const PictureFigures& picture) {
  nlohmann::ordered_json line = {{"program", program},         {"renderer", renderer},
                                 {"scene", scene.name},        {"width", scene.width},
                                 {"height", scene.height},     {"objects", scene.objects},
                                 {"vertices", scene.vertices}, {"triangles", scene.triangles},
                                 {"threads", threads},         {"frames", times.frames()}};
  for (const auto& [key, milliseconds] : times.summary()) line[key] = milliseconds;
  line["scene_ms"] = scene.scene_ms;
  line["covered"] = picture.covered;
  line["mean_red"] = picture.mean_red;
  fmt::print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

}  // namespace morphcl::bench
