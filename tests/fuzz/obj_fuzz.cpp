// OBJ models. What follows the first zero byte is the material library m.mtl, what follows the second one a morph
// target.
#include "host/scene/obj/obj_import.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

std::string_view take_part(std::string_view& text) {
  const std::string_view part = text.substr(0, text.find('\0'));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace morphcl::fuzz;
  std::string_view text = text_of(data, size);
  const std::string model = folder().write("model.obj", take_part(text));
  folder().write("m.mtl", take_part(text));
  const std::string target = folder().write("target.obj", text);
  load_and_plan(model);
  may_refuse([&] { morphcl::import_obj_targets(model, {target}); });
  return 0;
}
