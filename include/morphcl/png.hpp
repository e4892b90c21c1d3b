// Frames as PNG files, for tools that do not read OpenEXR: written whole or not at all, read back with every check.
//
// A file has the colours of a frame alone: R, G, B, A with 8 or 16 bits a sample, sRGB, alpha straight. Each sample is
// correctly rounded, halfway values up: of the stored colour divided by the stored alpha, both clamped to 0..1, alpha
// before it divides; of alpha without an encoding. Colour is 0 where alpha is 0, NaN is 0. So colours brighter than
// white, depth, cameras and the frame rate are only in EXR files (exr.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "morphcl/exr.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// Writes as write_exr does, with its errors. Of the attributes the frame number, the fingerprint and the deviation are
// stored, in text chunks; of the last, other characters than printable ASCII as '?'. Returns the pixel hash that the
// file holds. Error(usage) for other bits than 8 and 16, a frame without colour, or a fingerprint of other characters
// than printable ASCII.
//
// The hash is xxh3-128, seed 0, 32 hex digits of its canonical form, over: width, height and bits, three 32-bit
// integers, little-endian; the samples R, G, B, A, row by row from the top, those of 16 bits with the high byte first,
// as in the file. The compressed bytes may differ between machines, the pixels and their hash do not.
std::string write_png(const std::string& path, const FrameBuffer& frame, const FrameAttributes& attributes = {},
                      int bits = 8, int threads = 1);

void check_png_bits(int bits);  // Error(usage) for others than 8 and 16

struct PngText {
  std::string key, value;  // UTF-8, of a tEXt chunk
};

struct PngDescription {
  std::int64_t width = 0, height = 0;  // pixels
  int bits = 8;                        // of a sample, or of an index of a palette
  std::string color;                   // grey, RGB, palette, grey and alpha, RGBA
  bool interlaced = false;
  std::vector<PngText> texts;  // in the file's order
  FrameAttributes
      attributes;           // frame number, fingerprint, deviation; the defaults for the rest and for what is missing
  std::string stored_hash;  // empty in a file that is not morphcl's
  std::string hash;         // of the pixels as decoded; empty where read_png() refuses them for what they are
};

// Of any PNG file, checked to its end; the pixels of those that have a hash are decoded, a few rows at a time.
// Error(cannot_read) when the file is missing, Error(bad_input) when it is damaged or no PNG file.
PngDescription describe_png(const std::string& path);

struct PngFrame {
  FrameBuffer frame;  // what the codes stand for, premultiplied and rounded to half; without depth
  PngDescription description;
};

// Error(cannot_read) when the file is missing, Error(bad_input) when it is damaged, interlaced, larger than
// FrameBuffer::max_side, or anything but RGBA of 8 or 16 bits.
PngFrame read_png(const std::string& path);

// Reads a frame back that was just written with this hash. Error(write_failed) when it reads differently or not at all;
// the file is removed then, so that what stands under a final name is whole.
void verify_png(const std::string& path, const std::string& hash);

// The description of the frame at `path` if it is whole, has samples of this many bits and is of the job with this
// fingerprint: its pixels, decoded, have the hash that it holds. Never throws: what cannot be read is not finished.
std::optional<PngDescription> finished_png(const std::string& path, const std::string& fingerprint, int bits);

}  // namespace morphcl
#pragma GCC visibility pop
