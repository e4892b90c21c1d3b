#include "host/image/png_lines.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <new>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

enum PngFilter : std::uint8_t { filter_none, filter_sub, filter_up, filter_average, filter_paeth };

std::uint8_t paeth_of(int left, int above, int above_left) {
  const int estimate = left + above - above_left;
  const int to_left = std::abs(estimate - left), to_above = std::abs(estimate - above);
  const int to_above_left = std::abs(estimate - above_left);
  if (to_left <= to_above && to_left <= to_above_left) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(to_above <= to_above_left ? above : above_left);
}

[[noreturn]] void refuse_pixels(const std::string& message) { throw Error(ErrorKind::bad_input, "", message); }

}  // namespace

PngLines::PngLines(std::int64_t lines, std::size_t line_bytes, std::size_t pixel_bytes,
                   std::function<void(int, std::span<const std::uint8_t>)> on_line)
    : lines_(lines),
      line_bytes_(line_bytes),
      pixel_bytes_(pixel_bytes),
      on_line_(std::move(on_line)),
      line_(line_bytes + 1),
      above_(line_bytes + 1) {
  if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
}

PngLines::~PngLines() { inflateEnd(&stream_); }

void PngLines::add(std::span<const std::uint8_t> bytes) {
  stream_.next_in = const_cast<std::uint8_t*>(bytes.data());  // only read
  stream_.avail_in = static_cast<uInt>(bytes.size());
  for (;;) {
    if (ended_ && stream_.avail_in > 0) refuse_pixels("more compressed bytes than pixels");
    if (ended_) return;
    std::uint8_t one_more = 0;  // room for a byte that must not come
    const bool complete = done_ == lines_;
    stream_.next_out = complete ? &one_more : line_.data() + filled_;
    stream_.avail_out = complete ? 1 : static_cast<uInt>(line_.size() - filled_);
    const uInt room = stream_.avail_out;
    const int status = inflate(&stream_, Z_NO_FLUSH);
    const std::size_t written = room - stream_.avail_out;
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      refuse_pixels(fmt::format("the compressed pixels are damaged ({})", stream_.msg ? stream_.msg : "zlib"));
    if (complete && written > 0) refuse_pixels("more compressed bytes than pixels");
    ended_ = status == Z_STREAM_END;
    filled_ += written;
    if (!complete && filled_ == line_.size()) finish_line();
    if (!ended_ && stream_.avail_in == 0 && stream_.avail_out > 0) return;
    if (status == Z_BUF_ERROR && written == 0) return;
  }
}

void PngLines::finish_line() {
  undo_filter(line_[0]);
  on_line_(static_cast<int>(done_), {line_.data() + 1, line_bytes_});
  line_.swap(above_);
  filled_ = 0;
  ++done_;
}

void PngLines::undo_filter(std::uint8_t filter) {
  std::uint8_t* const line = line_.data() + 1;
  const std::uint8_t* const above = above_.data() + 1;
  const std::size_t back = pixel_bytes_, bytes = line_bytes_;
  const auto add_to = [line](std::size_t x, int value) { line[x] = static_cast<std::uint8_t>(line[x] + value); };
  switch (filter) {
    case filter_none:
      return;
    case filter_sub:
      for (std::size_t x = back; x < bytes; ++x) add_to(x, line[x - back]);
      return;
    case filter_up:
      for (std::size_t x = 0; x < bytes; ++x) add_to(x, above[x]);
      return;
    case filter_average:
      for (std::size_t x = 0; x < bytes; ++x) add_to(x, ((x < back ? 0 : line[x - back]) + above[x]) / 2);
      return;
    case filter_paeth:
      for (std::size_t x = 0; x < bytes; ++x)
        add_to(x, x < back ? above[x] : paeth_of(line[x - back], above[x], above[x - back]));
      return;
    default:
      refuse_pixels(fmt::format("line {} has the filter {}, which is none", done_, filter));
  }
}

void PngLines::finish() const {
  if (done_ < lines_) refuse_pixels(fmt::format("the compressed pixels end after {} of {} lines", done_, lines_));
  if (!ended_) refuse_pixels("the compressed pixels end before their checksum");
}

}  // namespace morphcl
