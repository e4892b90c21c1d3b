// The header of an EXR file as texts, for people and programs: any scanline, tiled, deep or multi-part file.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace morphcl {

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
