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

void FrameTimes::add(double first_ms, double second_ms) {
  first_ms_.push_back(first_ms);
  second_ms_.push_back(second_ms);
  processor_end_ = std::clock();
}

std::vector<std::pair<std::string, double>> FrameTimes::summary() const {
  const double processor_ms = 1000.0 * static_cast<double>(processor_end_ - processor_start_) / CLOCKS_PER_SEC;
  std::vector<double> whole(first_ms_);
  for (std::size_t i = 0; i < whole.size(); ++i) whole[i] += second_ms_[i];
  return {{first_step_ + "_ms", median(first_ms_)},
          {second_step_ + "_ms", median(second_ms_)},
          {"frame_ms", median(whole)},
          {"fastest_ms", *std::min_element(whole.begin(), whole.end())},
          {"cpu_ms", processor_ms / static_cast<double>(whole.size())}};
}

void print_report(const std::string& program, const std::string& renderer, const BenchScene& scene,
                  const Options& options, const FrameTimes& times, const PictureFigures& picture) {
  nlohmann::ordered_json line = {{"program", program},      {"renderer", renderer},   {"scene", scene.name},
                                 {"width", scene.width},    {"height", scene.height}, {"threads", options.threads},
                                 {"frames", times.frames()}};
  for (const auto& [key, milliseconds] : times.summary()) line[key] = milliseconds;
  line["covered"] = picture.covered;
  line["mean_red"] = picture.mean_red;
  fmt::print("{}\n", line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

}  // namespace morphcl::bench
