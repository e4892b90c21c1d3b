#include "host/image/zlib_encoder.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <new>
#include <vector>

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
  std::size_t encode(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) override {
    return libdeflate_zlib_compress(compressor_.get(), in.data(), in.size(), out.data(), out.size());
  }

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

#if MORPHCL_HAS_ISAL
// Level 1: levels 2 and 3 take as long or longer and save less than 1 %.
class IgzipEncoder : public ZlibEncoder {
 public:
  std::size_t encode(std::span<const std::uint8_t> in, std::span<std::uint8_t> out) override {
    isal_deflate_init(&stream_);
    stream_.level = 1;
    stream_.level_buf = level_memory_.data();
    stream_.level_buf_size = static_cast<std::uint32_t>(level_memory_.size());
    stream_.gzip_flag = IGZIP_ZLIB;
    stream_.next_in = const_cast<std::uint8_t*>(in.data());  // only read
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<std::uint32_t>(out.size());
    // igzip 2.30's main loop on AVX2 starts a stream with a hash of its own address, so that now and then a match is
    // found or missed by chance. A few bytes in a block of their own start the stream in another loop; they cost some
    // 15 bytes, and then the same input gives the same stream.
    const std::size_t opening = std::min(in.size(), opening_bytes);
    deflate(opening, SYNC_FLUSH);
    deflate(in.size() - opening, NO_FLUSH);
    return stream_.internal_state.state == ZSTATE_END ? stream_.total_out : 0;
  }

 private:
  static constexpr std::size_t opening_bytes = 8;

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

std::string_view fast_zlib_library() {
#if MORPHCL_HAS_ISAL
  return "igzip";
#else
  return "libdeflate";
#endif
}

}  // namespace morphcl
