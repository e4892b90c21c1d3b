// The peer's files: half RGBA through the stock OpenEXR library.
#pragma once

#include <cstdint>
#include <string>

namespace morphcl::bench {

struct ExrSettings {
  int zlib_level = 1;     // 1 to 9; ZIP compression
  int threads_aside = 0;  // that compress beside the one that writes; 0: none
};

class ExrWriter {
 public:
  explicit ExrWriter(const ExrSettings& settings);

  // `pixels`: four halves R, G, B, A a pixel, bottom row first. Overwrites `path`. Error(write_failed).
  void write(const std::string& path, const std::uint16_t* pixels, int width, int height) const;

 private:
  int zlib_level_;
};

}  // namespace morphcl::bench
