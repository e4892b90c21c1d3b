// Frames as OpenEXR files: written whole or not at all, read back with every check.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/frame.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// The names behind the ids of Cryptomatte layers: JSON objects of each name with its id as 8 hex digits.
struct CryptomatteManifests {
  std::string objects = {}, materials = {};  // "": not known
};

// What a frame's file says about the frame. No date, host or path: two runs give the same bytes.
struct FrameAttributes {
  std::int64_t frame = 0;  // stored as imageCounter, and with a rate of up to 30 as timeCode
  // Stored as framesPerSecond; numerator 0 to 2^31 - 1, denominator 1 to 2^31 - 1.
  std::int64_t fps_numerator = 25, fps_denominator = 1;
  // morphcl's convention: column vectors, the eye looks down -z. Stored as worldToCamera: row vectors, +z is the
  // viewing direction.
  glm::dmat4 world_to_eye{1.0};
  // morphcl's convention: x and y from -1 to 1, y up. Stored as worldToNDC: row vectors, (0, 0) is the upper left and
  // (1, 1) the lower right corner. Both matrices give screenWindowCenter and screenWindowWidth; they are
  // stored in fp32.
  glm::dmat4 world_to_ndc{1.0};
  std::string fingerprint = {};  // of the shot and the settings; a resumed job trusts only frames with its own
  std::string deviation = {};    // Renderer::deviation(); stored as morphclDeviation unless it is empty
  double z_error = 0;            // that Z was rounded within (round_depth()); stored as morphclZError unless it is 0
  double p_error = 0,
         n_error = 0;  // the same of P and N (round_position(), round_normal()): morphclPError, morphclNError
  ChannelNames channel_names = ChannelNames::plain;  // what the file calls the frame's planes
  // Of a frame with crypto_object or crypto_material; null: its layers are described without a manifest.
  std::shared_ptr<const CryptomatteManifests> manifests = {};
};

// none rle zips zip zip:small piz pxr24 b44 b44a dwaa dwab; the first six are lossless. zip and zip:small make files of
// the same format: the one in the least time, the other with the least bytes.
const std::vector<std::string>& compression_names();
void check_compression(const std::string& name);  // Error(usage) lists the names when `name` is none of them
// The same, and Error(usage) for a lossy compression of Cryptomatte's channels, whose ids it would change.
void check_compression(const std::string& name, ChannelSet channels);

// Writes to a temporary name in the same folder, flushes to disk, renames; missing folders are made. Returns the pixel
// hash that the file holds: of the pixels that a reader gets, so with a lossy compression not that of `frame`.
// Error(cannot_create) when the folder or the file cannot be made, Error(write_failed) when not all of it reaches the
// disk; in both cases nothing is left behind and an older file still stands. Error(usage) for another compression, a
// lossy one of Cryptomatte's channels, a frame without channels, or attributes that cannot be stored. More than one
// thread helps a single frame; frames that are written at the same time do better with one thread each.
std::string write_exr(const std::string& path, const FrameBuffer& frame, const FrameAttributes& attributes = {},
                      const std::string& compression = "zip", int threads = 1);

struct ExrFrame {
  FrameBuffer frame;           // the pixels of the data window
  FrameAttributes attributes;  // the defaults where the file has none
  std::string stored_hash;     // empty in a file that is not morphcl's
  std::string hash;            // of the pixels as decoded
};

// Decodes every pixel of the first part, scan lines or tiles, of the planes that a frame can hold, under any of
// ChannelNames, to the types that it has for them: R, G, B, A to half, Z to float and so on. A plane that is missing of
// a channel of which others are there is 0, a missing A is 1. Error(cannot_read) when the file is missing,
// Error(bad_input) when it is damaged, deep, larger than FrameBuffer::max_side or has none of these channels.
ExrFrame read_exr(const std::string& path);

// Reads a frame back that was just written with this hash. Error(write_failed) when it reads differently or not at all;
// the file is removed then, so that what stands under a final name is whole.
void verify_exr(const std::string& path, const std::string& hash);

// The frame at `path` if it is whole and of the job with this fingerprint: its pixels, decoded, have the hash that it
// holds. Never throws: what cannot be read is not finished.
std::optional<ExrFrame> read_finished_frame(const std::string& path, const std::string& fingerprint);
bool is_finished_frame(const std::string& path, const std::string& fingerprint);

// ---- headers --------------------------------------------------------------------------------------------------------
//
// The header of an EXR file as texts, for people and programs: any scanline, tiled, deep or multi-part file.

struct ExrWindow {
  glm::ivec2 min, max;  // pixels, both inclusive
};

struct ExrChannel {
  std::string name, type;  // type: half, float or uint
};

struct ExrAttribute {
  std::string name, type, value;  // value: empty for a type that has no short text
};

struct ExrDescription {
  int parts = 1;  // what follows is the first part's
  ExrWindow data_window, display_window;
  std::string compression;
  std::vector<ExrChannel> channels;
  std::vector<ExrAttribute> attributes;  // those that the fields above do not show, in the file's (alphabetical) order
};

// Error(cannot_read) when the file is missing, Error(bad_input) when it is no EXR file or its header is damaged.
ExrDescription describe_exr(const std::string& path);

}  // namespace morphcl
#pragma GCC visibility pop
