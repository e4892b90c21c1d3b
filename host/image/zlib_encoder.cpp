#include "host/image/zlib_encoder.hpp"

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>

#if MORPHCL_HAS_ISAL
#include <isa-l/igzip_lib.h>
#endif

namespace morphcl {

namespace {

// Measured on filtered scan lines of rendered frames: level 3 is as fast as 1 and 2 and smaller; 6 takes half as long
// again as 3, and 9 four to ten times as long for 5 % less.
[[maybe_unused]] constexpr int fast_level = 3;
constexpr int small_level = 6;

class LibdeflateEncoder : public ZlibEncoder {
 public:
  explicit LibdeflateEncoder(int level) : compressor_(libdeflate_alloc_compressor(level)) {
    if (!compressor_) throw std::bad_alloc();
  }
  std::size_t encode(std::span<const std::uint8_t> in, std::uint32_t, std::span<std::uint8_t> out) override {
    return libdeflate_zlib_compress(compressor_.get(), in.data(), in.size(), out.data(), out.size());
  }

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

// Room for the blocks of this many bytes, whatever they are, and whatever block the library chooses.
std::size_t room_for_blocks(std::size_t bytes) { return bytes + bytes / 8 + 4096; }

class ZlibDeflatePieces : public DeflatePieces {
 public:
  ZlibDeflatePieces() {
    constexpr int level = 1, without_head = -15, memory_level = 8;
    if (deflateInit2(&stream_, level, Z_DEFLATED, without_head, memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~ZlibDeflatePieces() override { deflateEnd(&stream_); }
  ZlibDeflatePieces(const ZlibDeflatePieces&) = delete;
  ZlibDeflatePieces& operator=(const ZlibDeflatePieces&) = delete;

  void encode(std::span<const std::uint8_t> in, std::vector<std::uint8_t>& out) override {
    deflateReset(&stream_);
    out.resize(room_for_blocks(in.size()));
    stream_.next_in = const_cast<std::uint8_t*>(in.data());  // only read
    stream_.avail_in = static_cast<uInt>(in.size());
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<uInt>(out.size());
    deflate(&stream_, Z_SYNC_FLUSH);
    out.resize(out.size() - stream_.avail_out);
  }

 private:
  z_stream stream_{};
};

#if MORPHCL_HAS_ISAL
// Level 1: levels 2 and 3 take as long or longer and save less than 1 %.
class IgzipEncoder : public ZlibEncoder, public DeflatePieces {
 public:
  std::size_t encode(std::span<const std::uint8_t> in, std::uint32_t adler, std::span<std::uint8_t> out) override {
    if (out.size() < head.size() + sizeof adler) return 0;
    begin(in, out.subspan(head.size(), out.size() - head.size() - sizeof adler));
    const std::size_t opening = std::min(in.size(), opening_bytes);
    deflate(opening, SYNC_FLUSH);
    deflate(in.size() - opening, NO_FLUSH);
    if (stream_.internal_state.state != ZSTATE_END) return 0;
    std::copy(head.begin(), head.end(), out.begin());
    const std::size_t end = head.size() + stream_.total_out;
    for (std::size_t i = 0; i < sizeof adler; ++i) out[end + i] = static_cast<std::uint8_t>(adler >> (24 - 8 * i));
    return end + sizeof adler;
  }

  void encode(std::span<const std::uint8_t> in, std::vector<std::uint8_t>& out) override {
    out.resize(room_for_blocks(in.size()));
    begin(in, out);
    const std::size_t opening = std::min(in.size(), opening_bytes);
    deflate(opening, SYNC_FLUSH);
    if (in.size() > opening) deflate(in.size() - opening, SYNC_FLUSH);
    out.resize(stream_.total_out);
  }

 private:
  // igzip 2.30's main loop on AVX2 starts a stream with a hash of its own address, so that now and then a match is
  // found or missed by chance. A few bytes in a block of their own start the stream in another loop; they cost some
  // 15 bytes, and then the same input gives the same stream.
  static constexpr std::size_t opening_bytes = 8;

  // Of zlib: deflate with a window of 32 KB, the fastest level.
  static constexpr std::array<std::uint8_t, 2> head{0x78, 0x01};

  void begin(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) {
    isal_deflate_init(&stream_);
    stream_.level = 1;
    stream_.level_buf = level_memory_.data();
    stream_.level_buf_size = static_cast<std::uint32_t>(level_memory_.size());
    stream_.gzip_flag = IGZIP_DEFLATE;
    stream_.next_in = const_cast<std::uint8_t*>(in.data());  // only read
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<std::uint32_t>(out.size());
  }

  void deflate(std::size_t bytes, int flush) {
    stream_.avail_in = static_cast<std::uint32_t>(bytes);
    stream_.flush = static_cast<std::uint16_t>(flush);
    stream_.end_of_stream = flush == NO_FLUSH;
    isal_deflate(&stream_);
  }

  isal_zstream stream_;
  std::vector<std::uint8_t> level_memory_ = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
};
#endif

}  // namespace

std::unique_ptr<ZlibEncoder> make_zlib_encoder(ZlibEffort effort) {
  if (effort == ZlibEffort::small) return std::make_unique<LibdeflateEncoder>(small_level);
#if MORPHCL_HAS_ISAL
  return std::make_unique<IgzipEncoder>();
#else
  return std::make_unique<LibdeflateEncoder>(fast_level);
#endif
}

std::unique_ptr<DeflatePieces> make_zlib_deflate_pieces() { return std::make_unique<ZlibDeflatePieces>(); }

std::unique_ptr<DeflatePieces> make_deflate_pieces() {
#if MORPHCL_HAS_ISAL
  return std::make_unique<IgzipEncoder>();
#else
  return make_zlib_deflate_pieces();
#endif
}

std::string_view fast_zlib_library() {
#if MORPHCL_HAS_ISAL
  return "igzip";
#else
  return "libdeflate";
#endif
}

}  // namespace morphcl
