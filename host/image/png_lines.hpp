// The lines of a PNG picture out of its zlib stream.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace morphcl {

class PngLines {
 public:
  // Of `lines` lines of `line_bytes` each, without the byte of their filter; `on_line` takes them. `pixel_bytes`: of a
  // pixel, which filters look back by.
  PngLines(std::int64_t lines, std::size_t line_bytes, std::size_t pixel_bytes,
           std::function<void(int y, std::span<const std::uint8_t> line)> on_line);
  ~PngLines();
  PngLines(const PngLines&) = delete;
  PngLines& operator=(const PngLines&) = delete;

  // The next bytes of the stream. Error(bad_input) where it is damaged, or holds more than these lines.
  void add(std::span<const std::uint8_t> bytes);
  // After the last: Error(bad_input) when lines are missing.
  void finish() const;

 private:
  void finish_line();
  void undo_filter(std::uint8_t filter);

  const std::int64_t lines_;
  const std::size_t line_bytes_, pixel_bytes_;
  const std::function<void(int, std::span<const std::uint8_t>)> on_line_;
  std::int64_t done_ = 0;            // lines
  std::vector<std::uint8_t> line_;   // its filter, and it
  std::vector<std::uint8_t> above_;  // the line before, whole, behind a byte without meaning
  std::size_t filled_ = 0;           // bytes of line_
  bool ended_ = false;               // the stream
  z_stream stream_{};
};

}  // namespace morphcl
