#include <ImfChannelList.h>
#include <ImfInputFile.h>

#include <algorithm>

#include "host/image/exr_attributes.hpp"
#include "host/image/exr_encode.hpp"
#include "host/image/exr_header_check.hpp"
#include "host/image/exr_planes.hpp"
#include "host/image/exr_stream.hpp"
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
  const Imf::ChannelList& channels = file.header().channels();
  const bool color = std::any_of(color_channel_names.begin(), color_channel_names.end(),
                                 [&](const char* name) { return channels.findChannel(name) != nullptr; });
  const bool depth = channels.findChannel(depth_channel_name) != nullptr;
  if (!color && !depth) throw Error(ErrorKind::bad_input, "", "has none of the channels R, G, B, A, Z");
  const Imath::Box2i window = file.header().dataWindow();
  FrameBuffer frame(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, color, depth);
  file.setFrameBuffer(planes_of(frame, window.min.x, window.min.y));
  file.readPixels(window.min.y, window.max.y);
  return frame;
}

ExrFrame decode(SizedInput& input) {
  return with_errors([&] {
    check_exr_header(input);
    Imf::InputFile file(input, 0);
    ExrFrame result{read_pixels(file), attributes_of(file.header()),
                    text_attribute(file.header(), pixel_hash_attribute), ""};
    result.hash = pixel_hash(result.frame);
    return result;
  });
}

std::string fingerprint_of(SizedInput& input) {
  return with_errors([&] {
    check_exr_header(input);
    return text_attribute(Imf::InputFile(input, 0).header(), fingerprint_attribute);
  });
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
    if (fingerprint_of(input) != fingerprint) return std::nullopt;  // the cheap question first
    ExrFrame frame = decode(input);
    if (frame.stored_hash.empty() || frame.stored_hash != frame.hash) return std::nullopt;
    return frame;
  } catch (...) {
    return std::nullopt;
  }
}

bool is_finished_frame(const std::string& path, const std::string& fingerprint) {
  return read_finished_frame(path, fingerprint).has_value();
}

}  // namespace morphcl
