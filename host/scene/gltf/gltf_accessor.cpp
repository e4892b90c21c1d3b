#include "host/scene/gltf/gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace morphcl {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian and read in place");

namespace {

struct ElementType {
  std::string_view name;
  std::size_t columns, rows;
};
constexpr std::array<ElementType, 7> element_types = {
    {{"SCALAR", 1, 1}, {"VEC2", 1, 2}, {"VEC3", 1, 3}, {"VEC4", 1, 4}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}}};

std::size_t component_size(GltfComponent component) {
  switch (component) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    case GltfComponent::uint32:
    case GltfComponent::float32:
      return 4;
  }
  return 0;
}

GltfComponent component_type(const GltfValue& json) {
  const std::uint64_t number = json.integer();
  if (number < 5120 || number > 5126 || number == 5124)
    json.fail(fmt::format("is {}; 5120, 5121, 5122, 5123, 5125 or 5126 are component types", number));
  return static_cast<GltfComponent>(number);
}

template <typename Component>
Component read(const char* bytes) {
  Component value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <typename T, typename Component>
T convert(Component value, bool normalized) {
  if constexpr (std::is_integral_v<Component> && std::is_floating_point_v<T>) {
    if (normalized)
      return static_cast<T>(std::max(static_cast<double>(value) / std::numeric_limits<Component>::max(), -1.0));
  }
  return static_cast<T>(value);
}

// Calls `use` with a value of the component's C++ type.
template <typename Use>
void with_component(GltfComponent component, Use&& use) {
  switch (component) {
    case GltfComponent::int8:
      return use(std::int8_t{});
    case GltfComponent::uint8:
      return use(std::uint8_t{});
    case GltfComponent::int16:
      return use(std::int16_t{});
    case GltfComponent::uint16:
      return use(std::uint16_t{});
    case GltfComponent::uint32:
      return use(std::uint32_t{});
    case GltfComponent::float32:
      return use(float{});
  }
}

}  // namespace

GltfAccessors::GltfAccessors(const GltfDocument& document) : document_(document) {
  const std::size_t count = document.count("accessors");
  document.budget().charge(count, sizeof(Accessor), document.path());
  accessors_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) accessors_.push_back(check(document.element("accessors", i)));
}

GltfAccessors::Accessor GltfAccessors::check(const GltfValue& json) const {
  Accessor accessor{json};
  accessor.component = component_type(json.get("componentType"));
  accessor.normalized = json.boolean("normalized", false);
  accessor.type = json.get("type").text();
  const auto type = std::find_if(element_types.begin(), element_types.end(),
                                 [&](const ElementType& known) { return known.name == accessor.type; });
  if (type == element_types.end())
    json.get("type").fail(
        fmt::format("is '{}'; SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4 are types", accessor.type));
  accessor.width = type->columns * type->rows;

  const std::uint64_t count = json.get("count").integer();
  if (count == 0) json.get("count").fail("is 0; at least 1 is needed");
  if (count > document_.limits().max_vertices)
    json.get("count").fail(
        fmt::format("claims {} elements; at most {} are read", count, document_.limits().max_vertices));
  accessor.count = static_cast<std::size_t>(count);

  // Each column of a matrix starts at a multiple of 4 bytes.
  const std::size_t column = type->rows * component_size(accessor.component);
  const std::size_t padded = type->columns == 1 ? column : (column + 3) / 4 * 4;
  const std::size_t packed = type->columns * padded, size = packed - padded + column;
  if (json.find("bufferView")) {
    accessor.view = check_view(json, accessor.count, packed, size, true);
  } else if (json.find("byteOffset")) {
    json.fail("has a byteOffset but no bufferView");
  }
  if (const auto sparse = json.find("sparse")) accessor.sparse = check_sparse(*sparse, accessor);
  return accessor;
}

GltfAccessors::Sparse GltfAccessors::check_sparse(const GltfValue& json, const Accessor& base) const {
  Sparse sparse;
  const std::uint64_t count = json.get("count").integer();
  if (count == 0 || count > base.count)
    json.get("count").fail(fmt::format("is {}; it must be from 1 to the accessor's count, {}", count, base.count));
  sparse.count = static_cast<std::size_t>(count);
  const GltfValue indices = json.get("indices"), values = json.get("values");
  sparse.index_component = component_type(indices.get("componentType"));
  if (sparse.index_component != GltfComponent::uint8 && sparse.index_component != GltfComponent::uint16 &&
      sparse.index_component != GltfComponent::uint32)
    indices.get("componentType").fail("is not unsigned; indices are 5121, 5123 or 5125");
  const std::size_t index_size = component_size(sparse.index_component);
  const std::size_t value_size = base.width * component_size(base.component);
  indices.get("bufferView");
  values.get("bufferView");
  sparse.indices = check_view(indices, sparse.count, index_size, index_size, false);
  sparse.values = check_view(values, sparse.count, value_size, value_size, false);
  return sparse;
}

GltfAccessors::View GltfAccessors::check_view(const GltfValue& owner, std::size_t count, std::size_t packed,
                                              std::size_t size, bool may_stride) const {
  const int index = owner.index("bufferView", document_.count("bufferViews"), "bufferViews");
  const GltfValue json = document_.element("bufferViews", static_cast<std::size_t>(index));
  const GltfValue buffer_index = json.get("buffer");
  const int buffer_number = buffer_index.index(document_.buffers().size(), "buffers");
  const std::uint64_t buffer_length =
      document_.element("buffers", static_cast<std::size_t>(buffer_number)).get("byteLength").integer();
  const std::uint64_t start = json.integer("byteOffset", 0), length = json.get("byteLength").integer();
  if (start > buffer_length || length > buffer_length - start)
    json.fail(fmt::format("bytes {} to {} lie outside buffers[{}] of {} bytes", start, start + length, buffer_number,
                          buffer_length));

  View view;
  view.stride = packed;
  if (const auto stride = json.find("byteStride")) {
    const std::uint64_t bytes = stride->integer();
    if (!may_stride) stride->fail("is not allowed where sparse indices or values are stored");
    if (bytes < std::max<std::size_t>(4, size) || bytes > 252)
      stride->fail(
          fmt::format("is {}; {} needs it from {} to 252", bytes, owner.path(), std::max<std::size_t>(4, size)));
    view.stride = static_cast<std::size_t>(bytes);
  }
  const std::uint64_t offset = owner.integer("byteOffset", 0);
  const std::uint64_t needed = std::uint64_t{count - 1} * view.stride + size;  // at most 2^27 * 252
  if (offset > length || needed > length - offset)
    owner.fail(
        fmt::format("bytes {} to {} lie outside bufferViews[{}] of {} bytes", offset, offset + needed, index, length));
  const GltfDocument::Buffer& buffer = document_.buffers()[static_cast<std::size_t>(buffer_number)];
  if (buffer.present)
    view.bytes = buffer.bytes.data() + start + offset;
  else
    view.missing_buffer = buffer_number;
  return view;
}

void GltfAccessors::require_data(const View& view, const Accessor& accessor) const {
  if (view.missing_buffer >= 0)
    accessor.json.fail(fmt::format("buffers[{}] has no data: no uri, and no binary chunk", view.missing_buffer));
}

template <typename T>
std::vector<T> GltfAccessors::decode(int number, Numbers numbers) const {
  const Accessor& accessor = accessors_[static_cast<std::size_t>(number)];
  require_data(accessor.view, accessor);
  require_data(accessor.sparse.indices, accessor);
  require_data(accessor.sparse.values, accessor);
  if (accessor.width > 4) accessor.json.fail("matrices are not read here");
  document_.budget().charge(accessor.count * accessor.width, sizeof(T), accessor.json.place());

  std::vector<T> values(accessor.count * accessor.width);
  with_component(accessor.component, [&](auto sample) {
    using Component = decltype(sample);
    const auto read_element = [&](const View& view, std::size_t from, std::size_t to) {
      for (std::size_t c = 0; c < accessor.width; ++c) {
        const auto value = read<Component>(view.bytes + from * view.stride + c * sizeof(Component));
        if constexpr (std::is_floating_point_v<Component>)
          if (numbers == Numbers::finite && !std::isfinite(value))
            accessor.json.fail(fmt::format("component {} of element {} is {}; it must be finite", c, to, value));
        values[to * accessor.width + c] = convert<T>(value, accessor.normalized);
      }
    };
    if (accessor.view.bytes)
      for (std::size_t i = 0; i < accessor.count; ++i) read_element(accessor.view, i, i);

    std::size_t next = 0;  // the smallest index that the rule of increasing indices allows
    for (std::size_t i = 0; i < accessor.sparse.count; ++i) {
      std::size_t target = 0;
      with_component(accessor.sparse.index_component, [&](auto index) {
        target = static_cast<std::size_t>(
            read<decltype(index)>(accessor.sparse.indices.bytes + i * accessor.sparse.indices.stride));
      });
      if (target < next || target >= accessor.count)
        accessor.json.fail(fmt::format("sparse index {} is {}; indices must increase and stay below the count, {}", i,
                                       target, accessor.count));
      next = target + 1;
      read_element(accessor.sparse.values, i, target);
    }
  });
  return values;
}

template std::vector<float> GltfAccessors::decode<float>(int, Numbers) const;
template std::vector<double> GltfAccessors::decode<double>(int, Numbers) const;
template std::vector<std::uint32_t> GltfAccessors::decode<std::uint32_t>(int, Numbers) const;

}  // namespace morphcl
