#include "bench/peers/llvmpipe/exr_writer.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include "morphcl/error.hpp"

namespace morphcl::bench {

ExrWriter::ExrWriter(const ExrSettings& settings) : zlib_level_(settings.zlib_level) {
  Imf::setGlobalThreadCount(settings.threads_aside);
}

void ExrWriter::write(const std::string& path, const std::uint16_t* pixels, int width, int height) const try {
  constexpr std::size_t pixel_bytes = 4 * sizeof(std::uint16_t);
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(width);
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = zlib_level_;
  Imf::FrameBuffer frame;
  // The library only reads through these pointers. Rows go backwards, as the file's first row is the upper one.
  char* last_row =
      reinterpret_cast<char*>(const_cast<std::uint16_t*>(pixels)) + row_bytes * static_cast<std::size_t>(height - 1);
  const char* const names[] = {"R", "G", "B", "A"};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    header.channels().insert(names[channel], Imf::Channel(Imf::HALF));
    frame.insert(names[channel],
                 Imf::Slice(Imf::HALF, last_row + channel * sizeof(std::uint16_t), pixel_bytes, 0 - row_bytes));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
} catch (const std::exception& error) {
  throw Error(ErrorKind::write_failed, path, error.what());
}

}  // namespace morphcl::bench
