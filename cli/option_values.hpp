// The texts that options take, read into numbers. Each throws Error(usage) that says what would be right.
#pragma once

#include <cstdint>
#include <string>

#include "morphcl/scene.hpp"
#include "morphcl/track.hpp"

namespace morphcl::cli {

struct ImageSize {
  int width, height;
};

ImageSize parse_size(const std::string& text);                          // "1920x1080": 1 to 16384 each
std::uint64_t parse_seed(const std::string& text);                      // 0 to 2^64 - 1
TimeBase parse_fps(const std::string& text);                            // "25" or "30000/1001": 1 to 1,000,000 each
double parse_exposure(const std::string& text);                         // stops: -30 to 30
int parse_png_bits(const std::string& text);                            // "8" or "16"
void set_channels(const std::string& list, ImageSettings& image);       // "RGBA,Z": names of channels, each once
void set_channel_names(const std::string& text, ImageSettings& image);  // "plain", "blender" or "nuke"
void set_compression(const std::string& name, ImageSettings& image);    // one of compression_names()
void set_samples(const std::string& text, ImageSettings& image);        // "1", "2", "4", "8" or "16"
void set_depth_buffer(const std::string& name, ImageSettings& image);   // the name of one of depth_formats
void set_visibility(const std::string& name, ImageSettings& image);     // the name of one of visibility_methods
// "1e-6": above 0, at most max_relative_error (max_absolute_error of N), and the image has Z, P or N. set_channels()
// without the channel takes it back.
void set_z_error(const std::string& text, ImageSettings& image);
void set_p_error(const std::string& text, ImageSettings& image);
void set_n_error(const std::string& text, ImageSettings& image);

}  // namespace morphcl::cli
