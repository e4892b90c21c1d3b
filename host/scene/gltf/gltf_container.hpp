// The bytes of a glTF file taken apart: the JSON text and, for .glb, the binary chunk.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace morphcl {

struct GltfContainer {
  std::string_view json;                   // views into the bytes given
  std::optional<std::string_view> binary;  // the BIN chunk of a .glb that has one
};

// A file that starts with the magic "glTF" is binary, whatever its name. Bytes after the length that its header says
// are left alone. Error(bad_input) for a broken header or chunk.
GltfContainer split_gltf(std::string_view bytes, const std::string& file);

// The bytes of a "data:" URI, base64 or percent-escaped. Error(bad_input) at `place` when it is malformed.
std::string decode_data_uri(std::string_view uri, const std::string& place);

// A URI reference with its percent escapes resolved. Error(bad_input) at `place` when an escape is malformed.
std::string decode_percent(std::string_view uri, const std::string& place);

}  // namespace morphcl
