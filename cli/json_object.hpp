// JSON for programs that read the tool's output: one object a line. Every object opens with "schema" and "type"; fields
// keep their order, and a later schema only adds fields.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace morphcl::cli {

using Json = nlohmann::ordered_json;

Json json_object(std::string_view type, const Json& fields);

// On one line. Bytes that are not UTF-8 become U+FFFD, numbers that are not finite null.
std::string line_of(const Json& object);

}  // namespace morphcl::cli
