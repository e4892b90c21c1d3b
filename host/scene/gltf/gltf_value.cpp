#include "host/scene/gltf/gltf_value.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "morphcl/error.hpp"

namespace morphcl {

GltfValue::GltfValue(const nlohmann::json& json, const std::string& file, std::string path)
    : json_(&json), file_(&file), path_(std::move(path)) {}

std::string GltfValue::place() const { return path_.empty() ? *file_ : fmt::format("{}: {}", *file_, path_); }

void GltfValue::fail(std::string_view what) const { throw Error(ErrorKind::bad_input, place(), what); }

std::optional<GltfValue> GltfValue::find(std::string_view key) const {
  if (!json_->is_object()) fail(fmt::format("must be an object, not {}", json_->type_name()));
  const auto member = json_->find(key);
  if (member == json_->end()) return std::nullopt;
  return GltfValue(*member, *file_, path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key));
}

GltfValue GltfValue::get(std::string_view key) const {
  std::optional<GltfValue> member = find(key);
  if (!member) fail(fmt::format("'{}' is missing", key));
  return *std::move(member);
}

std::vector<std::string> GltfValue::keys() const {
  if (!json_->is_object()) fail(fmt::format("must be an object, not {}", json_->type_name()));
  std::vector<std::string> names;
  for (auto member = json_->begin(); member != json_->end(); ++member) names.push_back(member.key());
  return names;
}

std::size_t GltfValue::size() const {
  if (!json_->is_array()) fail(fmt::format("must be an array, not {}", json_->type_name()));
  return json_->size();
}

GltfValue GltfValue::operator[](std::size_t i) const {
  if (i >= size()) fail(fmt::format("has no element {}", i));
  return GltfValue((*json_)[i], *file_, fmt::format("{}[{}]", path_, i));
}

double GltfValue::number() const {
  if (!json_->is_number()) fail(fmt::format("must be a number, not {}", json_->type_name()));
  return json_->get<double>();  // finite: the parser refuses numbers beyond the range of double
}

std::uint64_t GltfValue::integer() const {
  constexpr double limit = 9007199254740992.0;  // 2^53: beyond it, JSON numbers are not exact integers
  const double value = number();
  if (!(value >= 0 && value < limit) || value != static_cast<double>(static_cast<std::uint64_t>(value)))
    fail(fmt::format("must be a whole number from 0 to 2^53 - 1, not {}", value));
  return static_cast<std::uint64_t>(value);
}

bool GltfValue::boolean() const {
  if (!json_->is_boolean()) fail(fmt::format("must be true or false, not {}", json_->type_name()));
  return json_->get<bool>();
}

const std::string& GltfValue::text() const {
  if (!json_->is_string()) fail(fmt::format("must be a string, not {}", json_->type_name()));
  return json_->get_ref<const std::string&>();
}

std::vector<double> GltfValue::numbers() const {
  std::vector<double> values(size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const nlohmann::json& element = (*json_)[i];
    if (!element.is_number()) (*this)[i].number();  // fails and says where
    values[i] = element.get<double>();
  }
  return values;
}

std::vector<double> GltfValue::numbers(std::size_t count) const {
  if (size() != count) fail(fmt::format("has {} numbers; {} are needed", size(), count));
  return numbers();
}

int GltfValue::index(std::size_t count, std::string_view target) const {
  const std::uint64_t value = integer();
  if (value >= count) fail(fmt::format("names {}[{}], but there are {}", target, value, count));
  return static_cast<int>(value);
}

double GltfValue::number(std::string_view key, double otherwise) const {
  const auto member = find(key);
  return member ? member->number() : otherwise;
}

std::uint64_t GltfValue::integer(std::string_view key, std::uint64_t otherwise) const {
  const auto member = find(key);
  return member ? member->integer() : otherwise;
}

bool GltfValue::boolean(std::string_view key, bool otherwise) const {
  const auto member = find(key);
  return member ? member->boolean() : otherwise;
}

std::string GltfValue::text(std::string_view key, std::string_view otherwise) const {
  const auto member = find(key);
  return member ? member->text() : std::string(otherwise);
}

int GltfValue::index(std::string_view key, std::size_t count, std::string_view target) const {
  const auto member = find(key);
  return member ? member->index(count, target) : -1;
}

}  // namespace morphcl
