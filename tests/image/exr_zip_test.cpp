// morphcl's own ZIP path against OpenEXR's: the same header, the same prepared bytes, and files that decode to the
// frame.
#include "host/image/exr_zip.hpp"

#include <ImfChannelList.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>

#include "host/image/exr_byte_split.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_stream.hpp"
#include "host/image/exr_zip_chunk.hpp"
#include "host/image/running_adler32.hpp"
#include "tests/image/exr_chunks.hpp"
#include "tests/image/test_frames.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl {
namespace {

using namespace image_test;

struct ZipShape {
  int width, height;
  ChannelSet channels;
};
const std::vector<ZipShape> zip_shapes{
    {1, 1, default_channels},    {1, 1, color_alone},       {1, 1, depth_alone},
    {17, 3, default_channels},   {17, 3, color_alone},      {17, 3, depth_alone},
    {129, 65, default_channels}, {2, 16, default_channels}, {1087, 49, default_channels},
    {1, 1, every_channel},       {129, 33, every_channel},  {33, 17, ChannelSet{Channel::normal, Channel::object_id}}};

std::string name_of(const ZipShape& shape) {
  return std::to_string(shape.width) + " x " + std::to_string(shape.height) + " " + names_of(shape.channels);
}

int chunk_count(const FrameBuffer& frame) { return (frame.height() + 15) / 16; }

Imf::Header header_of(const FrameBuffer& frame) {
  Imf::Header header(frame.width(), frame.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  header.channels() = channel_list(named_planes(frame.channels(), ChannelNames::plain));
  return header;
}

std::vector<char> library_file(FrameBuffer& frame) {
  std::vector<char> bytes;
  {
    MemoryOutput output(bytes);
    Imf::OutputFile file(output, header_of(frame), 0);
    file.setFrameBuffer(slices_to_write(frame, named_planes(frame.channels(), ChannelNames::plain)));
    file.writePixels(frame.height());
  }
  return bytes;
}

std::vector<char> our_file(const FrameBuffer& frame, ZlibEffort effort = ZlibEffort::fast, int threads = 1) {
  std::vector<char> bytes;
  encode_exr_zip(bytes, header_of(frame), frame, ChannelNames::plain, effort, threads);
  return bytes;
}

// The bytes before deflation, and whether the chunk was deflated at all.
std::vector<std::uint8_t> inflated(const ExrChunk& chunk, std::size_t bytes) {
  if (chunk.data.size() >= bytes) return chunk.data;
  std::vector<std::uint8_t> out(bytes);
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  const auto result =
      libdeflate_zlib_decompress(decompressor, chunk.data.data(), chunk.data.size(), out.data(), out.size(), nullptr);
  libdeflate_free_decompressor(decompressor);
  EXPECT_EQ(result, LIBDEFLATE_SUCCESS);
  return out;
}

// What OpenEXR's file layout says, step by step.
std::vector<std::uint8_t> prepared_step_by_step(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> out;
  for (const std::size_t parity : {0, 1})
    for (std::size_t i = parity; i < bytes.size(); i += 2) out.push_back(bytes[i]);
  for (std::size_t i = out.size(); i-- > 1;) out[i] = static_cast<std::uint8_t>(out[i] - out[i - 1] + 128);
  return out;
}

TEST(ExrByteSplit, EqualsTheStepByStepDefinitionForEveryPieceLength) {
  std::vector<std::uint8_t> bytes(2 * 700);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i * 31 + i / 7);
  const std::vector<std::uint8_t> expected = prepared_step_by_step(bytes);
  for (std::size_t piece = 1; piece <= 700; piece += piece < 140 ? 1 : 97) {
    std::vector<std::uint8_t> out(bytes.size());
    ExrByteSplit split(out.data(), out.size());
    for (std::size_t first = 0; first < 700; first += piece)
      split.add(bytes.data() + 2 * first, std::min(piece, 700 - first));
    split.finish();
    EXPECT_EQ(out, expected) << "in pieces of " << piece;
  }
}

// Lengths about those from which on bytes are repeated, alone and between others.
TEST(ExrByteSplit, PairsByTurnsAreThePairsThemselves) {
  const std::vector<std::uint16_t> others{7, 0x1234, 0xffff, 0};
  for (const auto& [first, second] : {std::pair{0, 0}, {0x02f9, 0x5015}, {0x8001, 0x8001}, {0xff00, 0x00ff}})
    for (std::size_t pairs = 1; pairs <= 300; pairs += pairs < 20 ? 1 : 37)
      for (std::size_t before = 0; before <= others.size(); ++before) {
        std::vector<std::uint16_t> all(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(before));
        for (std::size_t i = 0; i < pairs; ++i) all.push_back(static_cast<std::uint16_t>(i % 2 == 0 ? first : second));
        all.insert(all.end(), others.begin(), others.end());
        std::vector<std::uint8_t> bytes(2 * all.size()), out(2 * all.size());
        std::memcpy(bytes.data(), all.data(), bytes.size());
        ExrByteSplit split(out.data(), out.size());
        if (before > 0) split.add(others.data(), before);
        split.add_by_turns(static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(second), pairs);
        split.add(others.data(), others.size());
        split.finish();
        ASSERT_EQ(out, prepared_step_by_step(bytes)) << pairs << " pairs behind " << before;
      }
}

TEST(RunningAdler32, OfBytesByTurnsIsThatOfTheBytes) {
  std::vector<std::uint8_t> bytes(400000);
  for (const auto& [first, second] : {std::pair{128, 128}, {255, 255}, {0, 0}, {0, 255}, {17, 3}})
    for (const std::size_t count :
         {0, 1, 2, 3, 4, 5, 255, 256, 5552, 5553, 65520, 65521, 65522, 131041, 131042, 131043, 400000}) {
      for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i % 2 == 0 ? first : second);
      RunningAdler32 adler;
      const std::uint8_t begin[] = {255, 255, 254, 1, 0, 77};
      std::uint32_t expected = libdeflate_adler32(1, begin, sizeof begin);
      adler.add(begin, sizeof begin);
      for (int twice = 0; twice < 2; ++twice) {
        adler.add_by_turns(bytes.data(), count);
        expected = libdeflate_adler32(expected, bytes.data(), count);
        ASSERT_EQ(adler.value(), expected) << count << " bytes " << first << " and " << second;
      }
    }
}

TEST(ExrZip, HeaderAndPreparedBytesAreTheLibrarys) {
  for (const ZipShape& shape : zip_shapes) {
    SCOPED_TRACE(name_of(shape));
    FrameBuffer frame = disc_frame(shape.width, shape.height, shape.channels);
    const int count = chunk_count(frame);
    const ExrChunks theirs = chunks_of(library_file(frame), count);
    for (const ZlibEffort effort : {ZlibEffort::fast, ZlibEffort::small}) {
      const ExrChunks ours = chunks_of(our_file(frame, effort), count);
      EXPECT_EQ(ours.header, theirs.header);
      for (int i = 0; i < count; ++i) {
        const ExrChunk &our = ours.chunks[static_cast<std::size_t>(i)],
                       &their = theirs.chunks[static_cast<std::size_t>(i)];
        const auto lines = static_cast<std::size_t>(std::min(16, shape.height - 16 * i));
        const std::size_t bytes = line_bytes(frame) * lines;
        EXPECT_EQ(our.first_line, 16 * i);
        // Where both deflated, they deflated the same bytes; a chunk that one of them stored has another form.
        if ((our.data.size() < bytes) == (their.data.size() < bytes)) {
          EXPECT_EQ(inflated(our, bytes), inflated(their, bytes)) << "chunk " << i;
        }
      }
    }
  }
}

TEST(ExrZip, EveryShapeComesBackBitForBit) {
  for (const ZipShape& shape : zip_shapes)
    for (const ZlibEffort effort : {ZlibEffort::fast, ZlibEffort::small}) {
      SCOPED_TRACE(name_of(shape));
      for (const bool noise : {false, true}) {
        const FrameBuffer frame = noise ? arbitrary_frame(shape.width, shape.height, shape.channels)
                                        : disc_frame(shape.width, shape.height, shape.channels);
        EXPECT_EQ(difference(frame, decode_exr(our_file(frame, effort)).frame), "");
      }
    }
}

TEST(ExrZip, NoiseIsStoredAsItIs) {
  const FrameBuffer frame = arbitrary_frame(200, 40, {Channel::color, Channel::depth});
  const ExrChunks ours = chunks_of(our_file(frame), 3);
  EXPECT_EQ(ours.chunks[0].data.size(), 200u * 12 * 16);
  EXPECT_EQ(ours.chunks[2].data.size(), 200u * 12 * 8);
  EXPECT_EQ(std::memcmp(ours.chunks[1].data.data(), frame.color_row(3, 16).data(), 400), 0) << "A comes first";
}

TEST(ExrZip, BlankBlocksAreBackgroundWhateverTheirMemoryHolds) {
  // 10 x 9 blocks, cut off on the right and below; rows of blocks that are blank wholly, in part and not at all.
  FrameBuffer marked = disc_frame(150, 140), plain = disc_frame(150, 140);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 10; ++x)
      if (y < 2 || y == 8 || (y % 2 == 0 && x % 3 != 0)) {
        make_blank(marked, x, y, 0x3c01);
        make_blank(plain, x, y, 0);
      }
  plain.data();  // nothing counts as blank any more
  ASSERT_TRUE(marked.blank_block(9, 8));
  ASSERT_FALSE(marked.blank_block(9, 4));
  ASSERT_FALSE(plain.blank_block(9, 8));
  for (const int threads : {1, 4})
    EXPECT_EQ(our_file(marked, ZlibEffort::fast, threads), our_file(plain)) << threads << " threads";
}

TEST(ExrZip, WideRunsOfBlankBlocksAreWhole) {
  FrameBuffer marked(2600, 20, {Channel::color, Channel::depth}), plain(2600, 20, {Channel::color, Channel::depth});
  for (int x = 0; x < (2600 + 15) / 16; ++x)
    for (const int y : {0, 1}) make_blank(marked, x, y, 0x3c01);
  for (int y = 0; y < plain.height(); ++y) std::ranges::fill(plain.depth_row(y), background_depth);
  EXPECT_EQ(our_file(marked), our_file(plain));
}

// Chunks that equal the one before are copied; one that only looks alike is not.
TEST(ExrZip, RepeatedChunksAreTheirOwnPixels) {
  for (const bool noise : {false, true}) {
    FrameBuffer frame = noise ? arbitrary_frame(100, 104, {Channel::color, Channel::depth}) : disc_frame(100, 104);
    const auto copy_lines = [&](std::size_t from, std::size_t to, std::size_t lines) {
      const std::size_t bytes = frame.row_bytes();
      std::copy_n(frame.data() + from * bytes, lines * bytes, frame.data() + to * bytes);
    };
    copy_lines(16, 32, 16);  // twice the same, then the same but for one bit, then the same again, shorter
    copy_lines(16, 48, 16);
    frame.depth_row(63)[99] += 1;
    copy_lines(48, 64, 16);
    copy_lines(80, 96, 8);
    const std::vector<char> file = our_file(frame);
    EXPECT_EQ(difference(frame, decode_exr(file).frame), "");
    const ExrChunks chunks = chunks_of(file, 7);
    EXPECT_EQ(chunks.chunks[1].data, chunks.chunks[2].data);
    EXPECT_EQ(our_file(frame, ZlibEffort::fast, 7), file) << "each chunk by itself";
  }
}

// A short chunk begins like the long one above it where everything is the same.
TEST(ExrZip, ShortLastChunkIsItsOwnLength) {
  const FrameBuffer frame(40, 40, {Channel::color, Channel::depth});
  for (const ExrChunk& chunk : chunks_of(our_file(frame), 3).chunks) {
    const std::size_t bytes = line_bytes(frame) * (chunk.first_line == 32 ? 8 : 16);
    EXPECT_EQ(inflated(chunk, bytes).size(), bytes);
  }
}

// What an encoder keeps from one frame must not come out of the next.
TEST(ExrZip, FramesOfOtherShapesFollowEachOther) {
  for (int round = 0; round < 2; ++round)
    for (const ZipShape& shape : zip_shapes) {
      SCOPED_TRACE(name_of(shape));
      const FrameBuffer first = disc_frame(shape.width, shape.height, shape.channels);
      const FrameBuffer second(shape.width, shape.height, shape.channels);
      EXPECT_EQ(difference(first, decode_exr(our_file(first)).frame), "");
      EXPECT_EQ(difference(second, decode_exr(our_file(second)).frame), "");
    }
}

TEST(ExrZip, SmallFilesAreSmaller) {
  const FrameBuffer frame = disc_frame(640, 480);
  EXPECT_LT(our_file(frame, ZlibEffort::small).size(), our_file(frame, ZlibEffort::fast).size());
}

}  // namespace
}  // namespace morphcl
