#include "host/image/thumbnail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
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

// What the output columns show of a row of blocks. Blank blocks add nothing, and their memory may hold anything.
struct BlockRow {
  std::vector<std::pair<std::size_t, std::size_t>> drawn;  // runs of columns without blank blocks: first, one behind
  std::vector<std::size_t> mixed;                          // columns with blank blocks and others
};

BlockRow block_row(const FrameBuffer& frame, int block_y, const std::vector<Span>& columns) {
  constexpr int side = FrameBuffer::block_side;
  BlockRow row;
  for (std::size_t x = 0; x < columns.size(); ++x) {
    const int first = columns[x].first / side, last = columns[x].last / side;
    int blank = 0;
    for (int block = first; block <= last; ++block) blank += frame.blank_block(block, block_y) ? 1 : 0;
    if (blank == last - first + 1) continue;
    if (blank > 0)
      row.mixed.push_back(x);
    else if (!row.drawn.empty() && row.drawn.back().second == x)
      ++row.drawn.back().second;
    else
      row.drawn.emplace_back(x, x + 1);
  }
  return row;
}

// The mean's sum over a span of a row: its first pixel, those between, its last.
float span_sum(const std::uint16_t* row, const Span& span, const std::array<float, 65536>& value) {
  float sum = span.first_share * value[row[span.first]];
  for (int i = span.first + 1; i < span.last; ++i) sum += value[row[i]];
  if (span.last > span.first) sum += span.last_share * value[row[span.last]];
  return sum;
}

// The same without the pixels of blank blocks.
float mixed_sum(const FrameBuffer& frame, int y, const std::uint16_t* row, const Span& span,
                const std::array<float, 65536>& value) {
  constexpr int side = FrameBuffer::block_side;
  float sum = 0;
  for (int i = span.first; i <= span.last; ++i)
    if (!frame.blank_block(i / side, y / side)) sum += span.share(i) * value[row[i]];
  return sum;
}

void add_row(const FrameBuffer& frame, int y, float row_share, const std::vector<Span>& columns, const BlockRow& blocks,
             std::vector<Pixel>& sums) {
  const auto& value = displayable_from_half();
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const std::uint16_t* const row = frame.color_row(static_cast<int>(channel), y).data();
    for (const auto& [first, end] : blocks.drawn)
      for (std::size_t x = first; x < end; ++x) sums[x][channel] += row_share * span_sum(row, columns[x], value);
    for (const std::size_t x : blocks.mixed)
      sums[x][channel] += row_share * mixed_sum(frame, y, row, columns[x], value);
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
  constexpr int side = FrameBuffer::block_side;
  int block_y = -1;
  BlockRow blocks;
  for (int y = 0; y < size.height; ++y) {
    std::fill(sums.begin(), sums.end(), Pixel{});
    const Span& span = rows[static_cast<std::size_t>(y)];
    for (int i = span.first; i <= span.last; ++i) {
      if (i / side != block_y) {
        block_y = i / side;
        blocks = block_row(frame, block_y, columns);
      }
      add_row(frame, i, span.share(i), columns, blocks, sums);
    }
    for (int x = 0; x < size.width; ++x)
      image.at(x, y) = over_background(sums[static_cast<std::size_t>(x)], area, static_cast<float>(gain));
  }
  return image;
}

}  // namespace morphcl
