#include "host/image/png_file.hpp"

#include <fmt/format.h>
#include <png.h>

#include "host/image/atomic_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

static_assert(sizeof(Rgb) == 3, "rows are handed to libpng as they are");

void write_png(const std::string& path, const RgbImage& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  std::vector<char> bytes(PNG_IMAGE_PNG_SIZE_MAX(header));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0)
    throw Error(ErrorKind::internal, path, fmt::format("cannot be encoded as PNG: {}", header.message));
  bytes.resize(size);
  write_file_atomically(path, bytes);
}

}  // namespace morphcl
