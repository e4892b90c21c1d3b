#include "host/image/exr_encode.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <string_view>

#include "host/image/exr_attributes.hpp"
#include "host/image/exr_compression.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_stream.hpp"
#include "host/image/exr_zip.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Of `zips`, which the library compresses. zlib's level 1 takes half the time of OpenEXR's default, 4; the files are up
// to twice as large, and still small beside what the other lossless compressions make of rendered frames.
constexpr int zips_level = 1;

Imf::Header make_header(const FrameBuffer& frame, const FrameAttributes& attributes, Imf::Compression compression,
                        const std::string& hash) {
  Imf::Header header(frame.width(), frame.height());
  header.compression() = compression;
  header.zipCompressionLevel() = zips_level;
  header.channels() = channel_list(named_planes(frame.channels(), attributes.channel_names));
  add_attributes(header, attributes, hash);
  return header;
}

void encode_by_library(std::vector<char>& bytes, const FrameBuffer& frame, const Imf::Header& header,
                       ChannelNames names, int threads) {
  if (threads > 1 && threads > Imf::globalThreadCount()) {
    try {
      Imf::setGlobalThreadCount(threads);
    } catch (const std::exception&) {
      threads = 1;  // the system starts no more
    }
  }
  MemoryOutput output(bytes);
  Imf::OutputFile file(output, header, threads > 1 ? threads : 0);
  file.setFrameBuffer(slices_to_write(frame, named_planes(frame.channels(), names)));
  file.writePixels(frame.height());
}

// Overwrites the hash in a file that was encoded with another one of the same length.
void replace_hash(std::vector<char>& bytes, const std::string& old_hash, const std::string& new_hash) {
  const auto at = std::search(bytes.begin(), bytes.end(), old_hash.begin(), old_hash.end());
  if (at == bytes.end()) throw Error(ErrorKind::internal, "", "the encoded header holds no pixel hash");
  std::copy(new_hash.begin(), new_hash.end(), at);
}

}  // namespace

std::string encode_exr(std::vector<char>& bytes, const FrameBuffer& frame, const FrameAttributes& attributes,
                       const std::string& compression, int threads) {
  if (frame.channels().empty()) throw Error(ErrorKind::usage, "", "a frame without channels; ask for RGBA or Z");
  const Imf::Compression method = exr_compression(compression);
  check_compression(compression, frame.channels());
  const std::string hash = pixel_hash(frame);
  try {
    const Imf::Header header = make_header(frame, attributes, method, hash);
    if (method == Imf::ZIP_COMPRESSION)
      encode_exr_zip(bytes, header, frame, attributes.channel_names, zip_effort(compression), threads);
    else
      encode_by_library(bytes, frame, header, attributes.channel_names, threads);
    if (is_lossless(method)) return hash;
    const std::string decoded_hash = decode_exr(bytes).hash;
    replace_hash(bytes, hash, decoded_hash);
    return decoded_hash;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::internal, "", error.what());
  }
}

}  // namespace morphcl
