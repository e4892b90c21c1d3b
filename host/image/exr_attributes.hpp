// Frame attributes in the header of an OpenEXR file.
#pragma once

#include <ImfHeader.h>

#include <string>

#include "morphcl/exr.hpp"

namespace morphcl {

// To a header that has its channels: framesPerSecond, imageCounter, timeCode, worldToCamera, worldToNDC,
// screenWindowCenter/Width, of frames with colour chromaticities (Rec. 709) and colorInteropID (lin_rec709_scene, of
// the Color Interop Forum), of those with Cryptomatte layers what add_cryptomatte() says, morphclFingerprint, where
// there is something to say morphclDeviation, morphclZError, morphclPError and
// morphclNError, pixelHash. timeCode counts whole seconds of round(fps)
// frames (no drop frame) and wraps at 24 hours; it is left out where SMPTE has no number for it: below 1 or above 30
// frames a second. Error(usage) for a rate or a frame number outside OpenEXR's integers.
void add_attributes(Imf::Header& header, const FrameAttributes& attributes, const std::string& pixel_hash);

// What of it a header holds; the defaults of FrameAttributes for the rest.
FrameAttributes attributes_of(const Imf::Header& header);

// The text of a string attribute, "" where there is none.
std::string text_attribute(const Imf::Header& header, const char* name);

inline constexpr const char* fingerprint_attribute = "morphclFingerprint";
inline constexpr const char* deviation_attribute = "morphclDeviation";
inline constexpr const char* z_error_attribute = "morphclZError";
inline constexpr const char* p_error_attribute = "morphclPError";
inline constexpr const char* n_error_attribute = "morphclNError";
inline constexpr const char* pixel_hash_attribute = "pixelHash";

}  // namespace morphcl
