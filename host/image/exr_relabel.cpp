#include "host/image/exr_relabel.hpp"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfVersion.h>

#include <array>
#include <cstring>

#include "host/image/exr_attributes.hpp"
#include "host/image/exr_compression.hpp"
#include "host/image/exr_stream.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Replaces `bytes` by the source with the offsets of its chunks moved to where they come to stand.
void relabel(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes,
             std::string& hash) {
  MemoryInput input(source);
  std::array<std::int32_t, 2> opening{};
  input.read(reinterpret_cast<char*>(opening.data()), sizeof opening);
  Imf::Header old;
  int version = opening[1];
  old.readFrom(input, version);
  const std::size_t old_table = input.tellg();

  hash = text_attribute(old, pixel_hash_attribute);
  // Not the old header itself: it may have attributes, like a time code, that this frame has not.
  Imf::Header header(old.displayWindow(), old.dataWindow());
  header.compression() = old.compression();
  header.channels() = old.channels();
  add_attributes(header, attributes, hash);
  MemoryOutput output(bytes);
  output.write(reinterpret_cast<const char*>(opening.data()), sizeof opening);
  header.writeTo(output);
  const std::size_t table = bytes.size();
  bytes.insert(bytes.end(), source.begin() + static_cast<std::ptrdiff_t>(old_table), source.end());

  const int lines = header.dataWindow().max.y + 1, per_chunk = lines_per_chunk(header.compression());
  const int chunks = per_chunk > 0 ? (lines + per_chunk - 1) / per_chunk : 0;
  if (chunks < 1 || bytes.size() - table < static_cast<std::size_t>(chunks) * sizeof(std::uint64_t))
    throw Error(ErrorKind::internal, "", "is no file that this library made");
  for (int chunk = 0; chunk < chunks; ++chunk) {
    char* const entry = bytes.data() + table + static_cast<std::size_t>(chunk) * sizeof(std::uint64_t);
    std::uint64_t offset = 0;
    std::memcpy(&offset, entry, sizeof offset);
    offset = offset - old_table + table;
    std::memcpy(entry, &offset, sizeof offset);
  }
}

}  // namespace

std::string relabel_exr(std::vector<char>& bytes, std::span<const char> source, const FrameAttributes& attributes) {
  try {
    std::string hash;
    relabel(bytes, source, attributes, hash);
    return hash;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, "", error.what());
  }
}

}  // namespace morphcl
