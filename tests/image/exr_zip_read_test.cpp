// morphcl's own reader of ZIP files against OpenEXR's: the same pixels, and nothing where the file is another one's.
#include "host/image/exr_zip_read.hpp"

#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "host/image/exr_byte_merge.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_planes.hpp"
#include "tests/image/exr_chunks.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl {
namespace {

using namespace image_test;

using HeaderChange = std::function<void(Imf::Header&)>;
const HeaderChange as_it_is = [](Imf::Header&) {};

// `change`: as if the file said something else.
std::optional<FrameBuffer> read_by_itself(const std::vector<char>& file, const HeaderChange& change = as_it_is) {
  MemoryInput input(file);
  std::array<std::int32_t, 2> opening{};
  input.read(reinterpret_cast<char*>(opening.data()), sizeof opening);
  Imf::Header header;
  header.readFrom(input, opening[1]);
  change(header);
  return read_exr_zip(input, header);
}

FrameBuffer read_by_library(const std::vector<char>& file, int width, int height, ChannelSet channels) {
  MemoryInput input(file);
  Imf::InputFile library(input, 0);
  const Imath::Box2i data = library.header().dataWindow();
  FrameBuffer frame(width, height, channels);
  library.setFrameBuffer(slices_to_read(frame, planes_in(library.header().channels()), data.min.x, data.min.y));
  library.readPixels(data.min.y, data.max.y);
  return frame;
}

std::vector<char> file_of(const FrameBuffer& frame, const std::string& compression = "zip") {
  std::vector<char> bytes;
  encode_exr(bytes, frame, {}, compression, 1);
  return bytes;
}

// By OpenEXR, with its own compressor.
std::vector<char> file_by_library(FrameBuffer& frame, const Imath::V2i& first = {0, 0},
                                  ChannelNames names = ChannelNames::plain) {
  const Imath::V2i last(first.x + frame.width() - 1, first.y + frame.height() - 1);
  Imf::Header header(Imath::Box2i({0, 0}, {499, 499}), Imath::Box2i(first, last));
  header.compression() = Imf::ZIP_COMPRESSION;
  const std::vector<NamedPlane> planes = named_planes(frame.channels(), names);
  header.channels() = channel_list(planes);
  std::vector<char> bytes;
  MemoryOutput output(bytes);
  {
    Imf::OutputFile file(output, header, 0);
    file.setFrameBuffer(slices_to_read(frame, planes, first.x, first.y));
    file.writePixels(frame.height());
  }
  return bytes;
}

TEST(ExrByteMerge, UndoesTheStepByStepDefinitionForEveryLength) {
  for (std::size_t count = 2; count < 200; count += 2) {
    std::vector<std::uint8_t> bytes(count), halves;
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * i * 31 + i / 7 + count);
    for (const std::size_t parity : {0, 1})
      for (std::size_t i = parity; i < count; i += 2) halves.push_back(bytes[i]);
    std::vector<std::uint8_t> differences = halves;
    for (std::size_t i = count; i-- > 1;) differences[i] = static_cast<std::uint8_t>(halves[i] - halves[i - 1] + 128);
    add_up_differences(differences.data(), count);
    EXPECT_EQ(differences, halves) << count << " bytes";
    std::vector<std::uint8_t> merged(count);
    merge_bytes(merged.data(), halves.data(), halves.data() + count / 2, count / 2);
    EXPECT_EQ(merged, bytes) << count << " bytes";
  }
}

TEST(ExrZipRead, EveryShapeIsReadAsByTheLibrary) {
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 3}, {2, 16}, {129, 65}, {1087, 49}})
    for (const ChannelSet channels : {default_channels, color_alone, depth_alone, every_channel})
      for (const bool noise : {false, true}) {
        SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + (noise ? ", noise" : ""));
        FrameBuffer frame = noise ? arbitrary_frame(width, height, channels) : disc_frame(width, height, channels);
        for (const std::vector<char>& file : {file_of(frame), file_of(frame, "zip:small"), file_by_library(frame)}) {
          const std::optional<FrameBuffer> read = read_by_itself(file);
          ASSERT_TRUE(read);
          EXPECT_EQ(difference(frame, *read), "");
          EXPECT_EQ(difference(read_by_library(file, width, height, channels), *read), "");
        }
      }
}

TEST(ExrZipRead, ADataWindowMayBeAnywhere) {
  FrameBuffer frame = disc_frame(100, 50);
  for (const Imath::V2i& first : {Imath::V2i(-7, -33), Imath::V2i(300, 411)}) {
    const std::optional<FrameBuffer> read = read_by_itself(file_by_library(frame, first));
    ASSERT_TRUE(read);
    EXPECT_EQ(difference(frame, *read), "");
  }
}

TEST(ExrZipRead, OtherFilesAreLeftToTheLibrary) {
  FrameBuffer frame = disc_frame(40, 40);
  for (const char* compression : {"none", "rle", "zips", "piz", "pxr24", "b44", "dwaa"})
    EXPECT_FALSE(read_by_itself(file_of(frame, compression))) << compression;
  const std::vector<std::pair<const char*, HeaderChange>> changes{
      {"one more channel", [](Imf::Header& h) { h.channels().insert("uv", Imf::Channel(Imf::HALF)); }},
      {"half a normal", [](Imf::Header& h) { h.channels().insert("N.X", Imf::Channel(Imf::HALF)); }},
      {"the same plane twice", [](Imf::Header& h) { h.channels().insert("depth.Z", Imf::Channel(Imf::FLOAT)); }},
      {"numbers in float", [](Imf::Header& h) { h.channels().insert("object_id", Imf::Channel(Imf::FLOAT)); }},
      {"a channel less",
       [](Imf::Header& h) {
         h.channels() = Imf::ChannelList();
         for (const char* name : {"R", "G", "B", "Z"})
           h.channels().insert(name, Imf::Channel(*name == 'Z' ? Imf::FLOAT : Imf::HALF));
       }},
      {"colour in float", [](Imf::Header& h) { h.channels()["G"].type = Imf::FLOAT; }},
      {"depth in half", [](Imf::Header& h) { h.channels()["Z"].type = Imf::HALF; }},
      {"from the bottom", [](Imf::Header& h) { h.lineOrder() = Imf::DECREASING_Y; }},
  };
  for (const auto& [name, change] : changes) EXPECT_FALSE(read_by_itself(file_of(frame), change)) << name;
}

// Any byte behind the header that is another one is found by the checksum of its chunk, but for the bits between
// deflate's blocks that mean nothing. (Chunks that are stored as they are have no checksum; the pixel hash finds
// those.)
TEST(ExrZipRead, DamageOfDeflatedChunksNeverGivesOtherPixels) {
  const FrameBuffer frame = uniform_frame(40, 40, 0.25f, 0.5f, 0.75f, 1.0f);
  const std::vector<char> file = file_of(frame);
  const std::size_t header = chunks_of(file, 3).header.size();
  int found = 0, all = 0;
  for (std::size_t at = header; at < file.size(); ++at)
    for (const int flip : {1, 0x80, 0xff}) {
      std::vector<char> damaged = file;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      const std::optional<FrameBuffer> read = read_by_itself(damaged);
      if (read)
        EXPECT_EQ(difference(frame, *read), "") << "byte " << at;
      else
        ++found;
      ++all;
    }
  EXPECT_GT(found, all * 9 / 10);
  for (std::size_t length = header; length < file.size(); ++length)
    EXPECT_FALSE(read_by_itself({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length)})) << length;
}

}  // namespace
}  // namespace morphcl
