// morphcl_bench_picture FILE.exr: reads a frame with the OpenEXR library and prints {"covered": pixels whose alpha is
// not 0, "mean_red": over all pixels, ...} as one line of JSON, by which files of different programs are compared.

#include <ImfArray.h>
#include <ImfRgbaFile.h>
#include <fmt/format.h>

#include "bench/report.hpp"

namespace morphcl::bench {

namespace {

void run(const char* path) {
  Imf::RgbaInputFile file(path);
  const Imath::Box2i window = file.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  Imf::Array2D<Imf::Rgba> pixels(height, width);
  file.setFrameBuffer(&pixels[0][0] - window.min.x - static_cast<std::ptrdiff_t>(window.min.y) * width, 1,
                      static_cast<std::size_t>(width));
  file.readPixels(window.min.y, window.max.y);

  static_assert(sizeof(Imf::Rgba) == 4 * sizeof(std::uint16_t));
  const auto* halves = reinterpret_cast<const std::uint16_t*>(&pixels[0][0]);
  const PictureView picture{halves, halves + 3, width, height, 4 * static_cast<std::size_t>(width), 4};
  const PictureFigures figures = picture_figures(picture);
  fmt::print("{{\"width\": {}, \"height\": {}, \"covered\": {}, \"mean_red\": {}}}\n", width, height, figures.covered,
             figures.mean_red);
}

}  // namespace

}  // namespace morphcl::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: morphcl_bench_picture FILE.exr\n");
    return 2;
  }
  try {
    morphcl::bench::run(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "morphcl_bench_picture: {}\n", error.what());
    return 66;
  }
}
