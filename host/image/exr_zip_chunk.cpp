#include "host/image/exr_zip_chunk.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "host/image/exr_byte_split.hpp"

namespace morphcl {

namespace {

static_assert(FrameBuffer::block_side == zip_chunk_lines, "a chunk is a row of blocks");

constexpr std::array<int, 4> alphabetical_planes{3, 2, 1, 0};  // A B G R of FrameBuffer's R G B A

// A line of background, so that blank blocks need not be read from memory.
constexpr std::size_t blank_pixels = 1024;
constexpr std::array<std::uint16_t, blank_pixels> blank_color{};
constexpr std::array<float, blank_pixels> blank_depth = [] {
  std::array<float, blank_pixels> line{};
  line.fill(background_depth);
  return line;
}();

}  // namespace

std::size_t line_bytes(const FrameBuffer& frame) {
  const std::size_t pixel_bytes =
      (frame.has_color() ? 4 * sizeof(std::uint16_t) : 0) + (frame.has_depth() ? sizeof(float) : 0);
  return static_cast<std::size_t>(frame.width()) * pixel_bytes;
}

void ExrZipChunks::begin(const FrameBuffer& frame) {
  frame_ = &frame;
  lines_before_ = 0;
  const std::size_t bytes = line_bytes(frame) * static_cast<std::size_t>(std::min(frame.height(), zip_chunk_lines));
  for (auto* buffer : {&prepared_, &prepared_before_, &data_})
    if (buffer->size() < bytes) buffer->resize(bytes);
}

// Runs of blank blocks and of others.
void ExrZipChunks::find_spans(int first_line) {
  constexpr std::size_t side = FrameBuffer::block_side;
  spans_.clear();
  const int block_y = first_line / static_cast<int>(side);
  const auto width = static_cast<std::size_t>(frame_->width());
  for (std::size_t first = 0; first < width; first += side) {
    const std::size_t count = std::min(side, width - first);
    const bool blank = frame_->blank_block(static_cast<int>(first / side), block_y);
    const bool goes_on = !spans_.empty() && spans_.back().blank == blank;
    if (goes_on && (!blank || spans_.back().count + count <= blank_pixels))
      spans_.back().count += count;
    else
      spans_.push_back({first, count, blank});
  }
}

void ExrZipChunks::prepare(int first_line, int lines) {
  ExrByteSplit split(prepared_.data(), line_bytes(*frame_) * static_cast<std::size_t>(lines));
  for (int y = first_line; y < first_line + lines; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * frame_->row_pitch();
    if (frame_->has_color())
      for (const int plane : alphabetical_planes)
        for (const Span& span : spans_)
          split.add(span.blank ? blank_color.data() : frame_->color(plane) + row + span.first, span.count);
    if (frame_->has_depth())
      for (const Span& span : spans_)
        split.add(span.blank ? blank_depth.data() : frame_->depth() + row + span.first, 2 * span.count);
  }
  split.finish();
}

void ExrZipChunks::store(int first_line, int lines) {
  std::uint8_t* out = data_.data();
  const auto append = [&](const auto* line) {
    const std::size_t bytes = static_cast<std::size_t>(frame_->width()) * sizeof *line;
    std::memcpy(out, line, bytes);
    out += bytes;
  };
  for (int y = first_line; y < first_line + lines; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * frame_->row_pitch();
    if (frame_->has_color())
      for (const int plane : alphabetical_planes) append(frame_->color(plane) + row);
    if (frame_->has_depth()) append(frame_->depth() + row);
  }
}

std::span<const std::uint8_t> ExrZipChunks::encode(int first_line) {
  const int lines = std::min(zip_chunk_lines, frame_->height() - first_line);
  find_spans(first_line);
  const bool blank = std::all_of(spans_.begin(), spans_.end(), [](const Span& span) { return span.blank; });
  const bool as_long = lines == lines_before_;
  const bool both_blank = blank && blank_before_;
  lines_before_ = lines;
  blank_before_ = blank;
  if (as_long && both_blank) return {data_.data(), data_bytes_};

  prepared_.swap(prepared_before_);
  prepare(first_line, lines);
  const std::size_t bytes = line_bytes(*frame_) * static_cast<std::size_t>(lines);
  if (as_long && std::memcmp(prepared_.data(), prepared_before_.data(), bytes) == 0) return {data_.data(), data_bytes_};

  data_bytes_ = encoder_->encode({prepared_.data(), bytes}, {data_.data(), bytes - 1});
  if (data_bytes_ == 0) {
    store(first_line, lines);
    data_bytes_ = bytes;
  }
  return {data_.data(), data_bytes_};
}

}  // namespace morphcl
