#include "host/scene/gltf/gltf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "host/scene/gltf/gltf_container.hpp"
#include "host/scene/model/input_file.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Extensions whose absence would change the geometry, and those of textures, which are not drawn in any case.
constexpr std::array known_extensions = {
    "KHR_mesh_quantization", "KHR_materials_unlit", "KHR_lights_punctual",
    "KHR_texture_transform", "KHR_texture_basisu",  "EXT_texture_webp",
};

// What nlohmann-json takes for a value: 16 bytes, an array or map node around it, and the allocator's overhead.
constexpr std::uint64_t bytes_per_json_value = 96;

// An upper bound of the number of values of a JSON text.
std::uint64_t count_values(std::string_view text) {
  std::uint64_t count = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == ',' || c == '[' || c == '{') {
      ++count;
    }
  }
  return count;
}

// "12:7", line and column of a byte, both from 1.
std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0
  return fmt::format("{}:{}", line + 1, before.size() - line_start + 1);
}

}  // namespace

GltfDocument::GltfDocument(const std::string& path, const ImportLimits& limits)
    : path_(path),
      limits_(limits),
      budget_(limits.max_decoded_bytes),
      file_(read_input_file(path, limits.max_decoded_bytes)) {
  budget_.charge(file_.size(), 1, path_);
  hash_.add(file_);
  const GltfContainer parts = split_gltf(file_, path_);
  parse(parts.json);
  check_version();
  check_extensions();
  load_buffers(parts.binary);
}

GltfDocument::~GltfDocument() = default;

void GltfDocument::parse(std::string_view text) {
  budget_.charge(count_values(text), bytes_per_json_value, path_);
  try {
    json_ = std::make_unique<nlohmann::json>(nlohmann::json::parse(text.begin(), text.end()));
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(
        ErrorKind::bad_input, fmt::format("{}:{}", path_, line_and_column(text, error.byte)),
        error.byte > text.size() ? "the JSON text ends too early: the file is truncated" : "this is not valid JSON");
  } catch (const nlohmann::json::exception&) {
    throw Error(ErrorKind::bad_input, path_, "a number of the JSON text is beyond the range of 64-bit floating point");
  }
}

GltfValue GltfDocument::root() const { return GltfValue(*json_, path_, ""); }

std::size_t GltfDocument::count(std::string_view array) const {
  const auto values = root().find(array);
  return values ? values->size() : 0;
}

GltfValue GltfDocument::element(std::string_view array, std::size_t i) const { return root().get(array)[i]; }

bool GltfDocument::uses_extension(std::string_view name) const {
  return std::find(extensions_used_.begin(), extensions_used_.end(), name) != extensions_used_.end();
}

void GltfDocument::check_version() const {
  const GltfValue asset = root().get("asset");
  const GltfValue version = asset.get("version");
  if (!version.text().starts_with("2.")) version.fail(fmt::format("is '{}'; glTF 2.0 is read", version.text()));
  if (const auto minimum = asset.find("minVersion"); minimum && minimum->text() != "2.0")
    minimum->fail(fmt::format("is '{}'; glTF 2.0 is read", minimum->text()));
}

void GltfDocument::check_extensions() {
  for (std::size_t i = 0; i < count("extensionsUsed"); ++i)
    extensions_used_.push_back(element("extensionsUsed", i).text());
  for (std::size_t i = 0; i < count("extensionsRequired"); ++i) {
    const GltfValue name = element("extensionsRequired", i);
    if (std::find(known_extensions.begin(), known_extensions.end(), name.text()) == known_extensions.end())
      name.fail(fmt::format("the extension '{}' is required to read this file, and is not known", name.text()));
  }
}

void GltfDocument::load_buffers(const std::optional<std::string_view>& binary_chunk) {
  for (std::size_t i = 0; i < count("buffers"); ++i) {
    const GltfValue buffer = element("buffers", i);
    const std::uint64_t length = buffer.get("byteLength").integer();
    const auto uri = buffer.find("uri");
    std::string_view bytes;
    if (!uri) {
      if (i != 0 || !binary_chunk) {
        buffers_.push_back({});
        continue;
      }
      bytes = *binary_chunk;
    } else if (uri->text().starts_with("data:")) {
      budget_.charge(uri->text().size(), 1, uri->place());
      bytes = *storage_.emplace_back(std::make_unique<std::string>(decode_data_uri(uri->text(), uri->place())));
    } else {
      const std::string file =
          confined_path(path_, decode_percent(uri->text(), uri->place()), limits_.allow_outside, uri->place());
      bytes = *storage_.emplace_back(std::make_unique<std::string>(read_input_file(file, budget_.left())));
      budget_.charge(bytes.size(), 1, uri->place());
      hash_.add(bytes);
    }
    if (bytes.size() < length)
      buffer.fail(fmt::format("byteLength is {}, but there are {} bytes: the data is truncated", length, bytes.size()));
    buffers_.push_back({bytes.substr(0, static_cast<std::size_t>(length)), true});
  }
}

}  // namespace morphcl
