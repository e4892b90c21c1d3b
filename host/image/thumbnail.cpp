#include "host/image/thumbnail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host/image/srgb.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// The source elements first..last whose area an output element covers, with the share of the outer two.
struct Span {
  int first = 0, last = 0;
  float first_share = 1, last_share = 1;
  float share(int i) const { return i == first ? first_share : i == last ? last_share : 1.0f; }
};

std::vector<Span> spans(int source, int output) {
  std::vector<Span> list(static_cast<std::size_t>(output));
  const double step = static_cast<double>(source) / output;
  for (int i = 0; i < output; ++i) {
    const double begin = i * step;
    const double end = i + 1 == output ? source : (i + 1) * step;
    Span& span = list[static_cast<std::size_t>(i)];
    span.first = std::min(static_cast<int>(begin), source - 1);
    span.last = std::max(span.first, static_cast<int>(std::ceil(end)) - 1);
    span.first_share = static_cast<float>(std::min(end, span.first + 1.0) - begin);
    span.last_share = static_cast<float>(end - span.last);
  }
  return list;
}

using Pixel = std::array<float, 4>;  // R, G, B, A, premultiplied

void add_row(const FrameBuffer& frame, int y, float row_share, const std::vector<Span>& columns,
             std::vector<Pixel>& sums) {
  const auto& value = displayable_from_half();
  for (int channel = 0; channel < 4; ++channel) {
    const std::span<const std::uint16_t> row = frame.color_row(channel, y);
    for (std::size_t x = 0; x < columns.size(); ++x) {
      const Span& span = columns[x];
      float sum = 0;
      for (int i = span.first; i <= span.last; ++i) sum += span.share(i) * value[row[static_cast<std::size_t>(i)]];
      sums[x][static_cast<std::size_t>(channel)] += row_share * sum;
    }
  }
}

Rgb over_background(const Pixel& sum, float area, float gain) {
  static const std::array<float, 3> background{linear_from_srgb8(picture_background.red),
                                               linear_from_srgb8(picture_background.green),
                                               linear_from_srgb8(picture_background.blue)};
  const float shown_background = std::max(0.0f, 1.0f - sum[3] / area);
  std::array<std::uint8_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = srgb8(sum[i] / area * gain + shown_background * background[i]);
  return {out[0], out[1], out[2]};
}

}  // namespace

PictureSize fitted_size(PictureSize frame, PictureSize box) {
  const double scale =
      std::min({1.0, static_cast<double>(box.width) / frame.width, static_cast<double>(box.height) / frame.height});
  const auto side = [scale](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); };
  return {side(frame.width), side(frame.height)};
}

RgbImage thumbnail(const FrameBuffer& frame, PictureSize size, double gain) {
  if (!frame.has_color()) throw Error(ErrorKind::usage, "", "a picture of a frame without colour; ask for RGBA");
  const std::vector<Span> columns = spans(frame.width(), size.width), rows = spans(frame.height(), size.height);
  const double pixels = static_cast<double>(frame.width()) * frame.height();
  const float area = static_cast<float>(pixels / size.width / size.height);
  RgbImage image(size.width, size.height, picture_background);
  std::vector<Pixel> sums(columns.size());
  for (int y = 0; y < size.height; ++y) {
    std::fill(sums.begin(), sums.end(), Pixel{});
    const Span& span = rows[static_cast<std::size_t>(y)];
    for (int i = span.first; i <= span.last; ++i) add_row(frame, i, span.share(i), columns, sums);
    for (int x = 0; x < size.width; ++x)
      image.at(x, y) = over_background(sums[static_cast<std::size_t>(x)], area, static_cast<float>(gain));
  }
  return image;
}

}  // namespace morphcl
