// A JSON value of a glTF file that knows where it stands, so that every complaint can say so: "model.gltf:
// nodes[3].mesh".
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphcl {

class GltfValue {
 public:
  // `json` and `file` outlive the value. `path` is "" for the root, else like "accessors[3].sparse".
  GltfValue(const nlohmann::json& json, const std::string& file, std::string path);

  const std::string& path() const { return path_; }     // "accessors[3]"
  std::string place() const;                            // "model.gltf: accessors[3]"
  [[noreturn]] void fail(std::string_view what) const;  // throws Error(bad_input) at place()

  // Members of an object; fail when this is not an object.
  std::optional<GltfValue> find(std::string_view key) const;
  GltfValue get(std::string_view key) const;  // fails when missing
  std::vector<std::string> keys() const;

  // Elements of an array; fail when this is not an array.
  std::size_t size() const;
  GltfValue operator[](std::size_t i) const;

  // This value itself; each fails on another type.
  double number() const;
  std::uint64_t integer() const;  // a non-negative whole number below 2^53
  bool boolean() const;
  const std::string& text() const;
  std::vector<double> numbers() const;
  std::vector<double> numbers(std::size_t count) const;  // fails when there are more or fewer
  // An index below `count`, the length of the array that `target` names.
  int index(std::size_t count, std::string_view target) const;

  // Members with a default.
  double number(std::string_view key, double otherwise) const;
  std::uint64_t integer(std::string_view key, std::uint64_t otherwise) const;
  bool boolean(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key, std::string_view otherwise) const;
  int index(std::string_view key, std::size_t count, std::string_view target) const;  // -1 when missing

 private:
  const nlohmann::json* json_;
  const std::string* file_;
  std::string path_;
};

}  // namespace morphcl
