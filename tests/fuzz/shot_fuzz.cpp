// Shot files.
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace morphcl::fuzz;
  load_and_plan(folder().write("shot.toml", text_of(data, size)));
  return 0;
}
