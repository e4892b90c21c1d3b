// A glTF file that is open for import: its JSON and the bytes of its buffers.
//
// The JSON is read with nlohmann-json and checked here and where it is used, not through tinygltf: version 2.7 takes a
// property of the wrong type as missing, cuts indices to 32 bits, descends into `extras` without a limit, and refuses
// valid buffers that are longer than their byteLength. It serves as the cross-check in the tests.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/gltf/gltf_value.hpp"
#include "host/scene/model/content_hash.hpp"
#include "host/scene/model/import_budget.hpp"
#include "host/scene/model/imported_model.hpp"

namespace morphcl {

class GltfDocument {
 public:
  // Reads the file and its buffers. Errors: see gltf_import.hpp.
  GltfDocument(const std::string& path, const ImportLimits& limits);
  ~GltfDocument();
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  GltfValue root() const;
  // Length and elements of a top-level array such as "nodes"; length 0 when the file has none.
  std::size_t count(std::string_view array) const;
  GltfValue element(std::string_view array, std::size_t i) const;

  bool uses_extension(std::string_view name) const;

  struct Buffer {
    std::string_view bytes;  // as many as byteLength says
    bool present = false;    // false: a placeholder without data, which extensions may fill
  };
  const std::vector<Buffer>& buffers() const { return buffers_; }

  const ImportLimits& limits() const { return limits_; }
  ImportBudget& budget() const { return budget_; }
  const std::string& path() const { return path_; }
  std::string content_hash() const { return hash_.hex(); }

 private:
  void parse(std::string_view text);
  void check_version() const;
  void check_extensions();
  // Where an extension stands that may decide geometry; "" when it only stands elsewhere, or nowhere.
  std::string geometry_place_of(std::string_view extension) const;
  bool points_at_materials_only() const;       // the animation pointers, of which there are some
  std::string read_uri(const GltfValue& uri);  // the bytes of the file
  void load_buffers(const std::optional<std::string_view>& binary_chunk);

  std::string path_;
  ImportLimits limits_;
  mutable ImportBudget budget_;
  ContentHash hash_;
  std::string file_;                                   // all bytes of the .gltf or .glb
  std::vector<std::unique_ptr<std::string>> storage_;  // external and decoded buffers
  std::unique_ptr<nlohmann::json> json_;
  std::vector<std::string> extensions_used_;
  std::vector<Buffer> buffers_;
};

}  // namespace morphcl
