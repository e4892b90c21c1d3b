// The chunks of a scan line file, found by its own offset table.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace morphcl::image_test {

struct ExrChunk {
  std::int32_t first_line;
  std::vector<std::uint8_t> data;
};

struct ExrChunks {
  std::vector<char> header;  // everything before the offset table
  std::vector<ExrChunk> chunks;
};

// Throws when a length or an offset leads out of the file.
inline ExrChunks chunks_of(const std::vector<char>& file, int chunk_count) {
  const auto read = [&](std::size_t at, auto& value) {
    if (at + sizeof value > file.size()) throw std::out_of_range("the file ends too early");
    std::memcpy(&value, file.data() + at, sizeof value);
  };
  const auto skip_text = [&](std::size_t at) {
    while (file.at(at) != 0) ++at;
    return at + 1;
  };
  std::size_t at = 8;  // magic number and version
  while (file.at(at) != 0) {
    std::int32_t bytes = 0;
    at = skip_text(skip_text(at));  // name and type
    read(at, bytes);
    at += sizeof bytes + static_cast<std::size_t>(bytes);
  }
  ++at;
  ExrChunks result;
  result.header.assign(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(at));
  for (int i = 0; i < chunk_count; ++i) {
    std::uint64_t offset = 0;
    std::int32_t bytes = 0;
    ExrChunk chunk{};
    read(at + static_cast<std::size_t>(i) * sizeof offset, offset);
    read(offset, chunk.first_line);
    read(offset + 4, bytes);
    if (bytes < 0 || offset + 8 + static_cast<std::uint64_t>(bytes) > file.size())
      throw std::out_of_range("a chunk goes beyond the file");
    const char* data = file.data() + offset + 8;
    chunk.data.assign(data, data + bytes);
    result.chunks.push_back(std::move(chunk));
  }
  return result;
}

}  // namespace morphcl::image_test
