#include "host/image/exr_zip_chunk.hpp"

#include <algorithm>
#include <cstring>

#include "host/image/exr_byte_split.hpp"
#include "host/image/running_adler32.hpp"

namespace morphcl {

namespace {

static_assert(FrameBuffer::block_side == zip_chunk_lines, "a chunk is a row of blocks");

}  // namespace

std::size_t line_bytes(const FrameBuffer& frame) {
  return static_cast<std::size_t>(frame.width()) * pixel_bytes(frame.channels());
}

void ExrZipChunks::begin(const FrameBuffer& frame, std::span<const NamedPlane> planes) {
  frame_ = &frame;
  planes_ = planes;
  lines_before_ = 0;
  const std::size_t bytes = line_bytes(frame) * static_cast<std::size_t>(std::min(frame.height(), zip_chunk_lines));
  for (auto* buffer : {&prepared_, &prepared_before_, &data_})
    if (buffer->size() < bytes) buffer->resize(bytes);
}

void ExrZipChunks::prepare(int first_line, int lines) {
  ExrByteSplit split(prepared_.data(), line_bytes(*frame_) * static_cast<std::size_t>(lines));
  for (int y = first_line; y < first_line + lines; ++y)
    for (const NamedPlane& plane : planes_) {
      const std::byte* const row = frame_->plane_row(plane.channel, plane.plane, y).data();
      const std::size_t element_bytes = bytes_of(plane_type(plane.channel));
      const std::uint32_t background = background_bits(plane.channel);
      for (const PixelSpan& span : spans_) {
        const std::size_t pairs = span.count * element_bytes / 2;
        if (span.blank)
          split.add_by_turns(background & 0xffff, static_cast<std::uint16_t>(background >> 16), pairs);
        else
          split.add(row + span.first * element_bytes, pairs);
      }
    }
  split.finish();
}

// Of the prepared bytes. Those of a blank span are by turns the same two, but for the first, which is the difference to
// the span before.
std::uint32_t ExrZipChunks::checksum(int lines) const {
  constexpr std::size_t different = 1;
  RunningAdler32 adler;
  const std::uint8_t *from = prepared_.data(), *at = from;  // what lies between is not added yet
  const auto add = [&](const PixelSpan& span, std::size_t bytes) {
    if (span.blank && bytes > different) {
      adler.add(from, static_cast<std::size_t>(at + different - from));
      adler.add_by_turns(at + different, bytes - different);
      from = at + bytes;
    }
    at += bytes;
  };
  for (int i = 0; i < 2 * lines; ++i)  // of both halves
    for (const NamedPlane& plane : planes_)
      for (const PixelSpan& span : spans_) add(span, span.count * bytes_of(plane_type(plane.channel)) / 2);
  adler.add(from, static_cast<std::size_t>(at - from));
  return adler.value();
}

void ExrZipChunks::store(int first_line, int lines) {
  std::uint8_t* out = data_.data();
  for (int y = first_line; y < first_line + lines; ++y)
    for (const NamedPlane& plane : planes_) {
      const std::span<const std::byte> row = frame_->plane_row(plane.channel, plane.plane, y);
      std::memcpy(out, row.data(), row.size());
      out += row.size();
    }
}

std::span<const std::uint8_t> ExrZipChunks::encode(int first_line) {
  const int lines = std::min(zip_chunk_lines, frame_->height() - first_line);
  find_spans(spans_, *frame_, first_line / zip_chunk_lines);
  const bool blank = std::all_of(spans_.begin(), spans_.end(), [](const PixelSpan& span) { return span.blank; });
  const bool as_long = lines == lines_before_;
  const bool both_blank = blank && blank_before_;
  lines_before_ = lines;
  blank_before_ = blank;
  if (as_long && both_blank) return {data_.data(), data_bytes_};

  prepared_.swap(prepared_before_);
  prepare(first_line, lines);
  const std::size_t bytes = line_bytes(*frame_) * static_cast<std::size_t>(lines);
  if (as_long && std::memcmp(prepared_.data(), prepared_before_.data(), bytes) == 0) return {data_.data(), data_bytes_};

  data_bytes_ = encoder_->encode({prepared_.data(), bytes}, checksum(lines), {data_.data(), bytes - 1});
  if (data_bytes_ == 0) {
    store(first_line, lines);
    data_bytes_ = bytes;
  }
  return {data_.data(), data_bytes_};
}

}  // namespace morphcl
