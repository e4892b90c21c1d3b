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

// Not read, and they decide what is drawn where: a file that requires one would be drawn wrong.
constexpr std::array<std::string_view, 6> geometry_extensions = {
    "KHR_draco_mesh_compression", "KHR_meshopt_compression", "EXT_meshopt_compression",
    "EXT_mesh_gpu_instancing",    "KHR_node_visibility",     "KHR_gaussian_splatting"};
constexpr std::string_view animation_pointer = "KHR_animation_pointer";

// What these begin is about looks, sound, physics or data, wherever it stands in the file; or it is read.
constexpr std::array<std::string_view, 16> harmless_extensions = {
    "KHR_mesh_quantization",  "KHR_lights_", "EXT_lights_",  "KHR_materials_", "EXT_materials_",
    "ADOBE_materials_",       "MSFT_lod",    "KHR_texture_", "EXT_texture_",   "MSFT_texture_",
    "MSFT_packing_",          "KHR_audio",   "KHR_xmp",      "KHR_physics_",   "EXT_mesh_features",
    "EXT_structural_metadata"};

// The parts of a file that decide geometry and motion, with the array inside an element that holds more of them.
struct GeometryPlace {
  std::string_view array, inner;
};
constexpr std::array<GeometryPlace, 7> geometry_places = {{{"meshes", "primitives"},
                                                           {"accessors", ""},
                                                           {"bufferViews", ""},
                                                           {"buffers", ""},
                                                           {"nodes", ""},
                                                           {"skins", ""},
                                                           {"animations", "channels"}}};

bool has_extension(const GltfValue& value, std::string_view name) {
  const auto extensions = value.find("extensions");
  return extensions && extensions->find(name);
}

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
      budget_(limits.max_decoded_bytes, limits.stop),
      file_(read_input_file(path, budget_.left_to_read())) {
  budget_.charge_file(path_, file_.size(), path_);
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
    const GltfValue required = element("extensionsRequired", i);
    const std::string& name = required.text();
    const auto begins = [&](std::string_view start) { return name.starts_with(start); };
    if (std::any_of(harmless_extensions.begin(), harmless_extensions.end(), begins)) continue;
    const bool refused = name == animation_pointer ? !points_at_materials_only()
                                                   : std::find(geometry_extensions.begin(), geometry_extensions.end(),
                                                               name) != geometry_extensions.end();
    std::string place;
    if (!refused) place = geometry_place_of(name);
    if (refused || !place.empty())
      required.fail(fmt::format("the extension '{}' is required to read this file, and is not known{}{}", name,
                                place.empty() ? "" : "; it stands in ", place));
  }
}

std::string GltfDocument::geometry_place_of(std::string_view extension) const {
  for (const GeometryPlace& where : geometry_places)
    for (std::size_t i = 0; i < count(where.array); ++i) {
      const GltfValue value = element(where.array, i);
      if (has_extension(value, extension)) return value.path();
      const auto inner = where.inner.empty() ? std::nullopt : value.find(where.inner);
      for (std::size_t k = 0; inner && k < inner->size(); ++k)
        if (has_extension((*inner)[k], extension)) return (*inner)[k].path();
    }
  return "";
}

bool GltfDocument::points_at_materials_only() const {
  std::size_t pointers = 0;
  for (std::size_t i = 0; i < count("animations"); ++i) {
    const GltfValue channels = element("animations", i).get("channels");
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const auto extensions = channels[c].get("target").find("extensions");
      const auto extension = extensions ? extensions->find(animation_pointer) : std::nullopt;
      if (!extension) continue;
      ++pointers;
      if (!extension->text("pointer", "").starts_with("/materials/")) return false;
    }
  }
  return pointers > 0;
}

// Exporters also write names as they are, with a '%' or a '\\' in them.
std::string GltfDocument::read_uri(const GltfValue& uri) {
  const auto read = [&](std::string_view name) {
    const std::string file = confined_path(path_, name, limits_.allow_outside, uri.place());
    std::string bytes = read_input_file(file, budget_.left_to_read());
    budget_.charge_file(file, bytes.size(), uri.place());
    return bytes;
  };
  try {
    return read(decode_percent(uri.text(), uri.place()));
  } catch (const Error&) {
    std::string with_slashes = uri.text();
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    for (const std::string& name : {uri.text(), with_slashes}) {
      try {
        return read(name);
      } catch (const Error&) {
      }
    }
    throw;
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
      bytes = *storage_.emplace_back(std::make_unique<std::string>(read_uri(*uri)));
      hash_.add(bytes);
    }
    if (bytes.size() < length)
      buffer.fail(fmt::format("byteLength is {}, but there are {} bytes: the data is truncated", length, bytes.size()));
    buffers_.push_back({bytes.substr(0, static_cast<std::size_t>(length)), true});
  }
}

}  // namespace morphcl
