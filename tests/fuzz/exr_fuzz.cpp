// OpenEXR images: headers and pixels.
#include "host/image/exr_encode.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace morphcl;
  using namespace morphcl::fuzz;
  const std::string_view bytes = text_of(data, size);
  may_refuse([&] { decode_exr(std::span(bytes.data(), bytes.size())); });
  may_refuse([&] { describe_exr(folder().write("image.exr", bytes)); });
  return 0;
}
