#include "cli/json_object.hpp"

namespace morphcl::cli {

Json json_object(std::string_view type, const Json& fields) {
  constexpr int schema = 1;
  Json object = {{"schema", schema}, {"type", type}};
  object.update(fields);
  return object;
}

std::string line_of(const Json& object) { return object.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace morphcl::cli
