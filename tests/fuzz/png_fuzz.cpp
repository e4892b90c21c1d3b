// PNG images: every chunk and the pixels, as they are and with their CRCs mended, as a damaged chunk is not looked
// into.
#include <libdeflate.h>

#include <vector>

#include "host/image/png_chunks.hpp"
#include "host/image/png_encode.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

std::vector<char> with_right_checksums(std::string_view bytes) {
  constexpr std::size_t number_bytes = 4, type_bytes = 4;
  std::vector<char> mended(bytes.begin(), bytes.end());
  std::size_t at = morphcl::png_signature.size();
  while (at + number_bytes + type_bytes <= mended.size()) {
    const std::size_t length = morphcl::big_endian(mended.data() + at);
    at += number_bytes;
    if (length > mended.size() - at || mended.size() - at - length < type_bytes + number_bytes) break;
    const std::uint32_t checksum = libdeflate_crc32(0, mended.data() + at, type_bytes + length);
    at += type_bytes + length;
    for (std::size_t i = 0; i < number_bytes; ++i) mended[at + i] = static_cast<char>(checksum >> (24 - 8 * i) & 0xff);
    at += number_bytes;
  }
  return mended;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace morphcl;
  using namespace morphcl::fuzz;
  const std::string_view bytes = text_of(data, size);
  may_refuse([&] { decode_png(std::span(bytes.data(), bytes.size())); });
  const std::vector<char> mended = with_right_checksums(bytes);
  may_refuse([&] { decode_png(mended); });
  may_refuse([&] { describe_png(folder().write("image.png", {mended.data(), mended.size()})); });
  return 0;
}
