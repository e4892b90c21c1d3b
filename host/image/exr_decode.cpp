#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <ImfVersion.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "host/image/exr_attributes.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_header_check.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_stream.hpp"
#include "host/image/exr_zip_read.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Runs `read`; what OpenEXR throws becomes Error(bad_input).
template <class Read>
auto with_errors(Read read) {
  try {
    return read();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ErrorKind::bad_input, "", error.what());
  }
}

FrameBuffer read_pixels(Imf::InputFile& file) {
  const std::vector<NamedPlane> planes = planes_in(file.header().channels());
  if (planes.empty())
    throw Error(ErrorKind::bad_input, "",
                "has none of the channels of a frame: R, G, B, A, Z and those of N, P and so on");
  const Imath::Box2i window = file.header().dataWindow();
  FrameBuffer frame(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channels_of(planes));
  file.setFrameBuffer(slices_to_read(frame, planes, window.min.x, window.min.y));
  file.readPixels(window.min.y, window.max.y);
  return frame;
}

// Of a file of one part of scan lines; nothing for any other, or one that OpenEXR is to say what is wrong with. The
// stream stands behind it then.
std::optional<Imf::Header> plain_header(SizedInput& input) {
  try {
    std::array<std::int32_t, 2> opening{};  // magic number; version and flags
    input.read(reinterpret_cast<char*>(opening.data()), sizeof opening);
    int version = opening[1];
    if ((version & ~Imf::LONG_NAMES_FLAG) != Imf::EXR_VERSION) return std::nullopt;
    Imf::Header header;
    header.readFrom(input, version);
    header.sanityCheck();
    return header;
  } catch (const Iex::BaseExc&) {
    return std::nullopt;
  }
}

ExrFrame frame_of(FrameBuffer&& pixels, const Imf::Header& header) {
  ExrFrame result{std::move(pixels), attributes_of(header), text_attribute(header, pixel_hash_attribute), ""};
  result.hash = pixel_hash(result.frame);
  return result;
}

// Nothing when `wanted` says no to the header, before any pixel is read.
std::optional<ExrFrame> decode(SizedInput& input, const std::function<bool(const Imf::Header&)>& wanted) {
  return with_errors([&]() -> std::optional<ExrFrame> {
    check_exr_header(input);
    if (const std::optional<Imf::Header> header = plain_header(input)) {
      if (!wanted(*header)) return std::nullopt;
      if (std::optional<FrameBuffer> pixels = read_exr_zip(input, *header))
        return frame_of(std::move(*pixels), *header);
    }
    input.seekg(0);
    Imf::InputFile file(input, 0);
    if (!wanted(file.header())) return std::nullopt;
    return frame_of(read_pixels(file), file.header());
  });
}

ExrFrame decode(SizedInput& input) {
  return std::move(*decode(input, [](const Imf::Header&) { return true; }));
}

}  // namespace

ExrFrame decode_exr(std::span<const char> bytes) {
  MemoryInput input(bytes);
  return decode(input);
}

ExrFrame read_exr(const std::string& path) {
  try {
    FileInput input(path);
    return decode(input);
  } catch (const Error& error) {
    throw error.at(path);
  }
}

std::optional<ExrFrame> read_finished_frame(const std::string& path, const std::string& fingerprint) {
  try {
    FileInput input(path);
    std::optional<ExrFrame> frame = decode(input, [&fingerprint](const Imf::Header& header) {
      return text_attribute(header, fingerprint_attribute) == fingerprint;  // the cheap question first
    });
    if (!frame || frame->stored_hash.empty() || frame->stored_hash != frame->hash) return std::nullopt;
    return frame;
  } catch (...) {
    return std::nullopt;
  }
}

bool is_finished_frame(const std::string& path, const std::string& fingerprint) {
  return read_finished_frame(path, fingerprint).has_value();
}

}  // namespace morphcl
