// An EXR file of float planes under any channel names: measurements of frames, not frames.
#pragma once

#include <string>
#include <vector>

namespace morphcl {

struct ExrLayer {
  std::string name;               // of the channel: R, G, B, A and Z are known to every viewer
  const float* values = nullptr;  // width * height, row by row from the top
};

// Whole or not at all, with the errors of write_file_atomically(); ZIP-compressed, the same planes give the same bytes.
// Error(usage) when a name is empty or comes twice.
void write_exr_layers(const std::string& path, int width, int height, const std::vector<ExrLayer>& layers);

}  // namespace morphcl
