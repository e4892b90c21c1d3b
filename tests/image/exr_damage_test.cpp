// Files that are cut, changed or hostile: found, refused in one line, without taking memory for what is not there.
#include <ImfAttribute.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "host/image/exr_encode.hpp"
#include "host/image/exr_stream.hpp"
#include "morphcl/error.hpp"
#include "morphcl/exr.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

using namespace image_test;
using namespace test_support;

const std::string fingerprint = "0123456789abcdef0123456789abcdef";

FrameAttributes job_attributes() {
  FrameAttributes attributes;
  attributes.fingerprint = fingerprint;
  return attributes;
}

std::vector<char> encoded(const FrameBuffer& frame, const std::string& compression) {
  std::vector<char> bytes;
  encode_exr(bytes, frame, job_attributes(), compression, 1);
  return bytes;
}

// The kind of the error that reading gives; reading has to fail, with the path and on one line.
ErrorKind kind_of_failure(const std::string& path) {
  EXPECT_FALSE(is_finished_frame(path, fingerprint));
  try {
    read_exr(path);
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), path);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_FALSE(error.message().empty());
    return error.kind();
  }
  ADD_FAILURE() << path << " was read";
  return ErrorKind::internal;
}

ErrorKind kind_of_failure(const std::vector<char>& bytes) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.exr", bytes);
  return kind_of_failure(folder / "a.exr");
}

// The value of the attribute; its length, 4 bytes, stands before it.
std::size_t place_of_value(const std::vector<char>& bytes, const std::string& name) {
  const std::string key = name + '\0';
  const auto at = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
  if (at == bytes.end()) throw std::logic_error("no attribute " + name);
  const auto type_end = std::find(at + static_cast<std::ptrdiff_t>(key.size()), bytes.end(), '\0');
  return static_cast<std::size_t>(type_end - bytes.begin()) + 1 + 4;
}

// Replaces the 32-bit number `offset` bytes into the value of the attribute; at -4 is its length.
std::vector<char> with_number(std::vector<char> bytes, const std::string& name, std::ptrdiff_t offset,
                              std::int32_t value) {
  std::memcpy(bytes.data() + place_of_value(bytes, name) + offset, &value, sizeof value);
  return bytes;
}

TEST(DamagedExr, EveryTruncationIsFound) {
  const TemporaryFolder folder;
  for (const std::string& compression : compression_names()) {
    const std::vector<char> whole = encoded(disc_frame(70, 90), compression);
    for (std::size_t tenth = 0; tenth < 10; ++tenth) {
      SCOPED_TRACE(testing::Message() << compression << " cut at " << tenth << "/10");
      write_bytes(folder / "a.exr",
                  {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * tenth / 10)});
      EXPECT_EQ(kind_of_failure(folder / "a.exr"), ErrorKind::bad_input);
    }
    write_bytes(folder / "a.exr", {whole.begin(), whole.end() - 1});
    EXPECT_EQ(kind_of_failure(folder / "a.exr"), ErrorKind::bad_input) << compression << " without its last byte";
  }
}

TEST(DamagedExr, EveryTruncationOfTheHeaderIsFound) {
  const std::vector<char> whole = encoded(disc_frame(5, 4), "zip");
  const TemporaryFolder folder;
  for (std::size_t size = 0; size < whole.size(); size += 3) {
    write_bytes(folder / "a.exr", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_EQ(kind_of_failure(folder / "a.exr"), ErrorKind::bad_input) << "cut after " << size << " bytes";
  }
}

// A file of its job with any bit changed is either found or still holds the frame's pixels (the bit was one of an
// attribute, or the table had a spare).
TEST(DamagedExr, NoFlippedBitChangesPixelsUnseen) {
  const FrameBuffer frame = disc_frame(9, 20);
  const TemporaryFolder folder;
  for (const char* compression : {"none", "rle", "zip", "piz"}) {
    std::vector<char> bytes = encoded(frame, compression);
    int found = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const int bit = static_cast<int>(i * 5 % 8);
      bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
      write_bytes(folder / "a.exr", bytes);
      bytes[i] = static_cast<char>(bytes[i] ^ (1 << bit));
      const auto finished = read_finished_frame(folder / "a.exr", fingerprint);
      if (!finished)
        ++found;
      else
        EXPECT_EQ(difference(frame, finished->frame), "") << compression << ": bit " << bit << " of byte " << i;
    }
    EXPECT_GT(found, static_cast<int>(bytes.size()) / 2) << compression;
  }
}

TEST(DamagedExr, FlippedPixelOfAnUncompressedFileIsFound) {
  std::vector<char> bytes = encoded(disc_frame(64, 64), "none");
  bytes[bytes.size() - 1000] = static_cast<char>(bytes[bytes.size() - 1000] ^ 1);
  const TemporaryFolder folder;
  write_bytes(folder / "a.exr", bytes);
  const ExrFrame read = read_exr(folder / "a.exr");  // it decodes; only the hash can tell
  EXPECT_NE(read.hash, read.stored_hash);
  EXPECT_FALSE(is_finished_frame(folder / "a.exr", fingerprint));
}

TEST(DamagedExr, VerificationRemovesWhatReadsBackDifferently) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.exr";
  const std::string hash = write_exr(path, disc_frame(64, 64), job_attributes(), "none");
  EXPECT_NO_THROW(verify_exr(path, hash));
  const std::vector<char> whole = bytes_of(path);
  std::vector<char> flipped = whole;
  flipped[flipped.size() - 1000] = static_cast<char>(flipped[flipped.size() - 1000] ^ 1);
  for (const std::vector<char>& bytes : {flipped, {whole.begin(), whole.end() - 1}, {}}) {
    write_bytes(path, bytes);
    try {
      verify_exr(path, hash);
      ADD_FAILURE() << "a damaged file was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::write_failed);
    }
    EXPECT_TRUE(folder.names().empty());
  }
  write_exr(path, disc_frame(64, 60), job_attributes(), "none");  // whole, but another frame
  EXPECT_THROW(verify_exr(path, hash), Error);
}

TEST(DamagedExr, FrameOfAnotherJobIsNotFinished) {
  const TemporaryFolder folder;
  write_exr(folder / "a.exr", disc_frame(8, 8), job_attributes(), "zip");
  EXPECT_TRUE(is_finished_frame(folder / "a.exr", fingerprint));
  EXPECT_FALSE(is_finished_frame(folder / "a.exr", "another"));
  EXPECT_FALSE(is_finished_frame(folder / "a.exr", ""));
}

TEST(DamagedExr, MissingFilesFoldersAndPipesCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(kind_of_failure(folder / "missing.exr"), ErrorKind::cannot_read);
  EXPECT_EQ(kind_of_failure(folder.path().string()), ErrorKind::cannot_read);
  ASSERT_EQ(mkfifo((folder / "pipe.exr").c_str(), 0600), 0);
  EXPECT_EQ(kind_of_failure(folder / "pipe.exr"), ErrorKind::cannot_read);  // and does not wait for a writer
}

TEST(DamagedExr, OtherFilesAreNoExr) {
  EXPECT_EQ(kind_of_failure(std::vector<char>{}), ErrorKind::bad_input);
  EXPECT_EQ(kind_of_failure(std::vector<char>(100, 'x')), ErrorKind::bad_input);
  const std::vector<char> magic_only{0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0};
  EXPECT_EQ(kind_of_failure(magic_only), ErrorKind::bad_input);
  const std::vector<char> empty_header{0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0, 0};
  EXPECT_EQ(kind_of_failure(empty_header), ErrorKind::bad_input);
  std::vector<char> endless_name(5000, 'n');
  std::copy(magic_only.begin(), magic_only.end(), endless_name.begin());
  EXPECT_EQ(kind_of_failure(endless_name), ErrorKind::bad_input);
}

TEST(DamagedExr, HugeAndUpsideDownWindowsAreRefused) {
  const std::vector<char> whole = encoded(disc_frame(40, 30), "zip");
  constexpr std::int32_t max = 2147483647, min = -2147483647 - 1;
  const struct {
    std::ptrdiff_t side;  // offset of first x, first y, last x, last y
    std::int32_t value;
  } cases[] = {{8, max}, {12, max}, {8, 100000}, {12, 100000}, {0, 40}, {4, 30}, {0, max}, {8, -1}, {12, min}};
  for (const auto& [side, value] : cases)
    EXPECT_EQ(kind_of_failure(with_number(whole, "dataWindow", side, value)), ErrorKind::bad_input)
        << "offset " << side << " value " << value;
  EXPECT_EQ(kind_of_failure(with_number(with_number(whole, "dataWindow", 0, min), "dataWindow", 8, max)),
            ErrorKind::bad_input);
}

// The largest window that is accepted, in a file of 30 lines: refused before its planes take memory.
TEST(DamagedExr, WindowLargerThanTheFileTakesNoMemory) {
  const std::vector<char> whole = encoded(disc_frame(40, 30), "zip");
  const auto with_window = [](const std::vector<char>& file, std::int32_t last_x, std::int32_t last_y) {
    return with_number(with_number(file, "dataWindow", 8, last_x), "dataWindow", 12, last_y);
  };
  const auto largest = [&](std::int32_t last_x, std::int32_t last_y) { return with_window(whole, last_x, last_y); };
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(kind_of_failure(largest(FrameBuffer::max_side - 1, FrameBuffer::max_side - 1)), ErrorKind::bad_input);
  EXPECT_EQ(kind_of_failure(largest(39, FrameBuffer::max_side - 1)), ErrorKind::bad_input);
  // Few large chunks, whose table is short.
  for (const char* compression : {"dwab", "piz", "b44a"})
    EXPECT_EQ(kind_of_failure(with_window(encoded(disc_frame(40, 30), compression), FrameBuffer::max_side - 1, 4000)),
              ErrorKind::bad_input)
        << compression;
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024) << "KiB more than before";
}

TEST(DamagedExr, AttributeLongerThanTheFileIsRefusedByName) {
  const std::vector<char> whole = encoded(disc_frame(40, 30), "zip");
  for (const std::string name : {"morphclFingerprint", "channels", "worldToNDC", "pixelHash"})
    for (const std::int32_t size : {2147483647, -1, -2147483647 - 1, 100'000'000}) try {
        decode_exr(with_number(whole, name, -4, size));
        ADD_FAILURE() << name << " of " << size << " bytes was read";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_EQ(error.message(),
                  "attribute '" + name + "' of " + std::to_string(size) + " bytes is longer than the file");
      }
}

// As OpenEXR itself writes them. What it does not read by the attribute's size must have the size that it reads:
// otherwise it goes on in the middle of a value, and takes gigabytes for what it finds there.
TEST(DamagedExr, AttributesHaveTheSizesOfTheirTypes) {
  for (const std::string type : {"box2f",        "box2i",
                                 "chlist",       "chromaticities",
                                 "compression",  "deepImageState",
                                 "double",       "envmap",
                                 "float",        "floatvector",
                                 "int",          "keycode",
                                 "lineOrder",    "m33d",
                                 "m33f",         "m44d",
                                 "m44f",         "preview",
                                 "rational",     "string",
                                 "stringvector", "tiledesc",
                                 "timecode",     "v2d",
                                 "v2f",          "v2i",
                                 "v3d",          "v3f",
                                 "v3i"}) {
    Imf::Header header(4, 4);
    header.channels().insert("R", Imf::Channel(Imf::HALF));
    ASSERT_TRUE(Imf::Attribute::knownType(type.c_str())) << type;
    header.insert("anAttribute", *std::unique_ptr<Imf::Attribute>(Imf::Attribute::newAttribute(type.c_str())));
    std::vector<char> bytes;
    std::vector<half> pixels(16);
    {
      MemoryOutput output(bytes);
      Imf::OutputFile file(output, header);
      Imf::FrameBuffer planes;
      planes.insert("R", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels.data()), 2, 8));
      file.setFrameBuffer(planes);
      file.writePixels(4);
    }
    EXPECT_NO_THROW(decode_exr(bytes)) << type;
    if (type == "string" || type == "stringvector" || type == "preview") continue;
    std::int32_t size = 0;
    std::memcpy(&size, bytes.data() + place_of_value(bytes, "anAttribute") - 4, sizeof size);
    for (const std::int32_t other : {size + 1, size + 3}) {
      try {
        decode_exr(with_number(bytes, "anAttribute", -4, other));
        ADD_FAILURE() << type << " of " << other << " bytes was read";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(error.message().find("attribute"), std::string::npos) << error.message();
      }
    }
  }
}

TEST(DamagedExr, UnknownCompressionIsRefused) {
  std::vector<char> bytes = encoded(disc_frame(40, 30), "zip");
  bytes = with_number(bytes, "lineOrder", 0, 0x01010101);
  EXPECT_EQ(kind_of_failure(bytes), ErrorKind::bad_input);
  const std::string key = std::string("compression\0compression\0\1\0\0\0", 28);
  const auto at = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
  ASSERT_NE(at, bytes.end());
  at[static_cast<std::ptrdiff_t>(key.size())] = 77;
  EXPECT_EQ(kind_of_failure(bytes), ErrorKind::bad_input);
}

}  // namespace
}  // namespace morphcl
