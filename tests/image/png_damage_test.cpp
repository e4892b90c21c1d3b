// PNG files that are cut, changed or hostile: found, refused in one line, without taking memory for what is not there.
#include <gtest/gtest.h>
#include <libdeflate.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>

#include "host/image/png_chunks.hpp"
#include "host/image/png_encode.hpp"
#include "host/image/running_adler32.hpp"
#include "host/image/zlib_encoder.hpp"
#include "morphcl/error.hpp"
#include "morphcl/png.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

const std::string job_fingerprint = "0123456789abcdef0123456789abcdef";

std::vector<char> png_of_job(const FrameBuffer& frame, int bits = 8) {
  FrameAttributes attributes;
  attributes.fingerprint = job_fingerprint;
  std::vector<char> bytes;
  encode_png(bytes, frame, attributes, bits, 1);
  return bytes;
}

// Why the bytes are refused; "" when they are read.
std::string refusal(const std::vector<char>& bytes) {
  try {
    decode_png(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
    EXPECT_EQ(error.message().find('\n'), std::string::npos);
    EXPECT_FALSE(error.message().empty());
    return error.message();
  }
  return "";
}

// The chunk of this type, from its length to its CRC.
std::pair<std::size_t, std::size_t> place_of_chunk(const std::vector<char>& bytes, const std::string& type) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = big_endian(bytes.data() + at) + std::size_t{12};
    if (std::string_view(bytes.data() + at + 4, 4) == type) return {at, size};
    at += size;
  }
  throw std::logic_error("no chunk " + type);
}

std::vector<std::uint8_t> data_of_chunk(const std::vector<char>& bytes, const std::string& type) {
  const auto [at, size] = place_of_chunk(bytes, type);
  return {bytes.begin() + static_cast<std::ptrdiff_t>(at + 8),
          bytes.begin() + static_cast<std::ptrdiff_t>(at + size - 4)};
}

// With a chunk of other data, whose CRC is right, in place of the first of this type.
std::vector<char> with_chunk(std::vector<char> bytes, const std::string& type, const std::vector<std::uint8_t>& data,
                             const std::string& new_type = "") {
  const auto [at, size] = place_of_chunk(bytes, type);
  std::vector<char> chunk;
  append_chunk(chunk, new_type.empty() ? type : new_type, data);
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  bytes.erase(begin, begin + static_cast<std::ptrdiff_t>(size));
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), chunk.begin(), chunk.end());
  return bytes;
}

std::vector<char> with_header(const std::vector<char>& bytes, std::size_t at, std::uint32_t value, std::size_t count) {
  std::vector<std::uint8_t> header = data_of_chunk(bytes, "IHDR");
  for (std::size_t i = 0; i < count; ++i) header[at + i] = static_cast<std::uint8_t>(value >> (8 * (count - 1 - i)));
  return with_chunk(bytes, "IHDR", header);
}

// A file whose filtered lines are these, in one IDAT chunk.
std::vector<char> png_of_lines(int width, int height, const std::vector<std::uint8_t>& lines) {
  std::vector<char> bytes =
      with_header(with_header(png_of_job(disc_frame(16, 16)), 0, static_cast<std::uint32_t>(width), 4), 4,
                  static_cast<std::uint32_t>(height), 4);
  std::vector<std::uint8_t> stream(lines.size() + 1000);
  RunningAdler32 adler;
  adler.add(lines.data(), lines.size());
  stream.resize(make_zlib_encoder(ZlibEffort::small)->encode(lines, adler.value(), stream));
  bytes.resize(place_of_chunk(bytes, "IDAT").first);
  append_chunk(bytes, "IDAT", stream);
  append_chunk(bytes, "IEND", {});
  return bytes;
}

TEST(DamagedPng, EveryTruncationIsFound) {
  for (const int bits : {8, 16}) {
    const std::vector<char> whole = png_of_job(disc_frame(40, 50), bits);
    ASSERT_EQ(refusal(whole), "");
    for (std::size_t size = 0; size < whole.size(); size += size < 300 ? 1 : 17)
      EXPECT_NE(refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size;
    EXPECT_NE(refusal({whole.begin(), whole.end() - 1}), "");
  }
}

// All that is not in a CRC is a length, a type or the CRC itself.
TEST(DamagedPng, EveryFlippedBitIsFound) {
  std::vector<char> bytes = png_of_job(disc_frame(9, 20));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const int bit = static_cast<int>(i * 5 % 8);
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
    EXPECT_NE(refusal(bytes), "") << "bit " << bit << " of byte " << i;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
  }
}

TEST(DamagedPng, ClaimsBeyondTheFileTakeNoMemory) {
  const std::vector<char> whole = png_of_job(disc_frame(40, 30));
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (const std::uint32_t side : {0u, 0x80000000u, 0xffffffffu}) {
    EXPECT_NE(refusal(with_header(whole, 0, side, 4)).find("1 to 2147483647"), std::string::npos) << side;
    EXPECT_NE(refusal(with_header(whole, 4, side, 4)).find("1 to 2147483647"), std::string::npos) << side;
  }
  for (const std::uint32_t side : {0x7fffffffu, 30000u})
    EXPECT_NE(refusal(with_header(with_header(whole, 0, side, 4), 4, side, 4)).find("more than a file of"),
              std::string::npos);
  EXPECT_NE(refusal(with_header(whole, 4, 32768, 4)), "") << "could be, by its size";
  EXPECT_NE(refusal(with_header(whole, 4, 31, 4)), "");
  EXPECT_NE(refusal(with_header(whole, 4, 29, 4)), "");
  EXPECT_NE(refusal(with_header(whole, 0, 41, 4)), "");
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 * 1024) << "KiB more than before";
}

TEST(DamagedPng, HeadersThatPngDoesNotHaveAreRefused) {
  const std::vector<char> whole = png_of_job(disc_frame(40, 30));
  for (const std::uint32_t bits : {0u, 1u, 4u, 7u, 32u, 255u})
    EXPECT_NE(refusal(with_header(whole, 8, bits, 1)), "") << bits;
  for (const std::uint32_t color : {1u, 5u, 7u, 255u}) EXPECT_NE(refusal(with_header(whole, 9, color, 1)), "") << color;
  for (const std::size_t field : {10u, 11u, 12u}) EXPECT_NE(refusal(with_header(whole, field, 9, 1)), "") << field;
  EXPECT_NE(refusal(with_chunk(whole, "IHDR", {1, 2, 3})), "");
  EXPECT_NE(refusal(with_chunk(whole, "IHDR", data_of_chunk(whole, "IHDR"), "sBIT")), "") << "no header";
  EXPECT_NE(refusal(with_chunk(whole, "sRGB", data_of_chunk(whole, "IHDR"), "IHDR")), "") << "two headers";
  EXPECT_NE(refusal(with_chunk(whole, "tEXt", {'n', 'o', ' ', 'k', 'e', 'y'})), "");
}

TEST(DamagedPng, ChunksLongerThanTheFileAreRefusedByName) {
  std::vector<char> bytes = png_of_job(disc_frame(40, 30));
  const std::size_t at = place_of_chunk(bytes, "tEXt").first;
  for (const int high : {0x7f, 0x80, 0xff}) {
    bytes[at] = static_cast<char>(high);
    EXPECT_NE(refusal(bytes).find("the chunk tEXt of "), std::string::npos) << refusal(bytes);
  }
}

TEST(DamagedPng, PixelsThatDoNotFillThePictureAreRefused) {
  const auto lines = [](std::size_t count, std::uint8_t filter = 0) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < count; ++i) {
      bytes.push_back(filter);
      bytes.insert(bytes.end(), 4 * 5, static_cast<std::uint8_t>(i));
    }
    return bytes;
  };
  EXPECT_EQ(refusal(png_of_lines(5, 7, lines(7))), "");
  for (std::uint8_t filter = 0; filter < 5; ++filter) EXPECT_EQ(refusal(png_of_lines(5, 7, lines(7, filter))), "");
  EXPECT_NE(refusal(png_of_lines(5, 7, lines(7, 5))), "");
  EXPECT_NE(refusal(png_of_lines(5, 7, lines(6))).find("6 of 7 lines"), std::string::npos);
  EXPECT_NE(refusal(png_of_lines(5, 7, lines(8))), "");
  EXPECT_NE(refusal(png_of_lines(5, 7, lines(100000))), "") << "and the rest is not decompressed";
  const std::vector<char> whole = png_of_lines(5, 7, lines(7));
  std::vector<std::uint8_t> stream = data_of_chunk(whole, "IDAT");
  stream.push_back(0);
  EXPECT_NE(refusal(with_chunk(whole, "IDAT", stream)), "") << "a byte behind the stream";
  stream.resize(stream.size() - 3);
  EXPECT_NE(refusal(with_chunk(whole, "IDAT", stream)), "") << "its checksum is cut";
  stream.pop_back();
  stream.insert(stream.end(), {0, 0, 0});
  EXPECT_NE(refusal(with_chunk(whole, "IDAT", stream)), "") << "its checksum is another one";
  EXPECT_NE(refusal(with_chunk(whole, "IDAT", {})), "");
  EXPECT_NE(refusal(with_chunk(whole, "IDAT", stream, "iDAT")), "") << "no pixels at all";
}

TEST(DamagedPng, OtherFilesAreNoPng) {
  EXPECT_EQ(refusal({}), "is not a PNG file");
  EXPECT_EQ(refusal(std::vector<char>(100, 'x')), "is not a PNG file");
  EXPECT_NE(refusal({png_signature.begin(), png_signature.end()}), "");
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  for (const char* name : {"missing.png", "pipe.png", "."}) {
    try {
      describe_png(folder / name);
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cannot_read);
      EXPECT_EQ(error.place(), (folder / name).string());
    }
    EXPECT_FALSE(finished_png(folder / name, "", 8));
  }
}

TEST(DamagedPng, VerificationRemovesWhatReadsBackDifferently) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.png";
  FrameAttributes attributes;
  attributes.fingerprint = job_fingerprint;
  const std::string hash = write_png(path, disc_frame(64, 64), attributes);
  EXPECT_NO_THROW(verify_png(path, hash));
  EXPECT_TRUE(finished_png(path, job_fingerprint, 8));
  const std::vector<char> whole = bytes_of(path);
  // Another picture's pixels under this one's hash, every checksum right: only the hash can tell.
  std::vector<char> exchanged = png_of_job(disc_frame(64, 64));
  exchanged.resize(place_of_chunk(exchanged, "IDAT").first);
  const std::vector<char> other = png_of_job(uniform_frame(64, 64, 1, 1, 1, 1));
  exchanged.insert(exchanged.end(), other.begin() + static_cast<std::ptrdiff_t>(place_of_chunk(other, "IDAT").first),
                   other.end());
  for (const std::vector<char>& bytes : {exchanged, {whole.begin(), whole.end() - 1}, {}}) {
    write_bytes(path, bytes);
    EXPECT_FALSE(finished_png(path, job_fingerprint, 8));
    try {
      verify_png(path, hash);
      ADD_FAILURE() << "a damaged file was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::write_failed);
    }
    EXPECT_TRUE(folder.names().empty());
  }
}

}  // namespace
}  // namespace morphcl
