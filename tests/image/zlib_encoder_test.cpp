// zlib streams of every kind of data, in exactly as much room as they need.
#include "host/image/zlib_encoder.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <vector>

namespace morphcl {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> kinds_of_data(std::size_t bytes, std::uint64_t seed = 1) {
  std::vector<Bytes> kinds(4, Bytes(bytes, 128));
  std::uint64_t state = seed;
  for (std::size_t i = 0; i < bytes; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const auto noise = static_cast<std::uint8_t>(state >> 56);
    kinds[1][i] = noise;
    if (noise < 8) kinds[2][i] = noise;                  // runs
    kinds[3][i] = static_cast<std::uint8_t>(noise & 3);  // few symbols
  }
  return kinds;
}

Bytes decoded(const std::uint8_t* stream, std::size_t stream_bytes, std::size_t bytes) {
  Bytes out(bytes);
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  std::size_t used = 0;
  const auto result =
      libdeflate_zlib_decompress_ex(decompressor, stream, stream_bytes, out.data(), out.size(), &used, nullptr);
  libdeflate_free_decompressor(decompressor);
  EXPECT_EQ(result, LIBDEFLATE_SUCCESS);
  EXPECT_EQ(used, stream_bytes);
  return out;
}

std::size_t encoded(ZlibEncoder& encoder, const Bytes& data, std::span<std::uint8_t> out) {
  return encoder.encode(data, libdeflate_adler32(1, data.data(), data.size()), out);
}

class ZlibEncoders : public testing::TestWithParam<ZlibEffort> {};

TEST_P(ZlibEncoders, StreamsDecodeToWhatWentIn) {
  const auto encoder = make_zlib_encoder(GetParam());
  for (const std::size_t bytes : {1, 2, 7, 100, 4096, 65536, 368640, 3000000})
    for (const Bytes& data : kinds_of_data(bytes)) {
      Bytes out(bytes + bytes / 8 + 1000);
      const std::size_t stream = encoded(*encoder, data, out);
      ASSERT_GT(stream, 0u);
      EXPECT_EQ(decoded(out.data(), stream, bytes), data);
    }
}

TEST_P(ZlibEncoders, NothingIsWrittenBeyondTheRoom) {
  const auto encoder = make_zlib_encoder(GetParam());
  for (const Bytes& data : kinds_of_data(20000)) {
    Bytes whole(30000);
    const std::size_t needed = encoded(*encoder, data, whole);
    for (const std::size_t room :
         {std::size_t{0}, std::size_t{1}, std::size_t{10}, needed / 2, needed - 1, needed, needed + 9, needed + 10}) {
      constexpr std::uint8_t guard = 0xa5;
      Bytes out(room + 64, guard);
      const std::size_t stream = encoded(*encoder, data, {out.data(), room});
      EXPECT_LE(stream, room);
      for (std::size_t i = room; i < out.size(); ++i)
        ASSERT_EQ(out[i], guard) << "room for " << room << " of " << needed;
      if (stream > 0) {
        EXPECT_EQ(decoded(out.data(), stream, data.size()), data);
      }
      if (room < needed || room > needed + 9) {
        EXPECT_EQ(stream > 0, room > needed) << "room for " << room << " of " << needed;
      }
    }
  }
}

// A frame's bytes must depend neither on where in memory an encoder is nor on what it has compressed before.
TEST_P(ZlibEncoders, StreamsDependOnTheirInputAlone) {
  std::vector<std::unique_ptr<ZlibEncoder>> encoders(6);
  for (auto& encoder : encoders) encoder = make_zlib_encoder(GetParam());
  const std::vector<Bytes> history = kinds_of_data(5000);
  for (std::size_t i = 0; i < 1500; ++i)
    for (const Bytes& data : kinds_of_data(1 + i % 300, i)) {
      Bytes first;
      for (std::size_t k = 0; k < encoders.size(); ++k) {
        Bytes out(6000);
        if (i % 10 == 0) encoded(*encoders[k], history[k % history.size()], out);
        out.assign(2000, 0);
        encoded(*encoders[k], data, out);
        if (k == 0) first = out;
        ASSERT_EQ(out, first) << data.size() << " bytes, encoder " << k;
      }
    }
}

// Pieces of several kinds in a row are one stream, once its end stands behind them.
TEST(DeflatePieces, DecodeTogetherAndDependOnTheirInputAlone) {
  for (const auto& make : {make_deflate_pieces, make_zlib_deflate_pieces}) {
    const auto encoder = make(), other = make();
    Bytes stream, all, piece, again;
    for (const std::size_t bytes : {1, 7, 8, 9, 100, 4096, 65536, 300000})
      for (const Bytes& data : kinds_of_data(bytes)) {
        encoder->encode(data, piece);
        other->encode(kinds_of_data(50)[1], again);
        other->encode(data, again);
        EXPECT_EQ(piece, again) << bytes;
        stream.insert(stream.end(), piece.begin(), piece.end());
        all.insert(all.end(), data.begin(), data.end());
      }
    stream.insert(stream.end(), {0x03, 0x00});
    Bytes out(all.size());
    libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
    EXPECT_EQ(
        libdeflate_deflate_decompress(decompressor, stream.data(), stream.size(), out.data(), out.size(), nullptr),
        LIBDEFLATE_SUCCESS);
    libdeflate_free_decompressor(decompressor);
    EXPECT_EQ(out, all);
  }
}

INSTANTIATE_TEST_SUITE_P(Efforts, ZlibEncoders, testing::Values(ZlibEffort::fast, ZlibEffort::small),
                         [](const auto& test) { return test.param == ZlibEffort::fast ? "fast" : "small"; });

}  // namespace
}  // namespace morphcl
