// Accessors: typed, strided, normalised and sparse views on a glTF file's buffers, checked once and decoded on demand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/gltf/gltf_document.hpp"

namespace morphcl {

// The component types' numbers are those of the file format.
enum class GltfComponent : std::uint32_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126,
};

class GltfAccessors {
 public:
  // Checks every accessor of the file: type, buffer view, stride and bounds, also of its sparse part; nothing is
  // decoded. Keeps a reference to `document`.
  explicit GltfAccessors(const GltfDocument& document);

  std::size_t size() const { return accessors_.size(); }
  std::size_t count(int accessor) const { return accessors_[accessor].count; }  // elements
  const std::string& type(int accessor) const { return accessors_[accessor].type; }
  GltfComponent component(int accessor) const { return accessors_[accessor].component; }
  bool normalized(int accessor) const { return accessors_[accessor].normalized; }
  std::string place(int accessor) const { return accessors_[accessor].json.place(); }
  [[noreturn]] void fail(int accessor, std::string_view what) const { accessors_[accessor].json.fail(what); }

  // What is expected of numbers: what only matters to the looks may be NaN or infinite, and is mended by its reader.
  enum class Numbers { finite, any };

  // All components, element after element, as T (float, double or std::uint32_t). Normalised integers become
  // c / (2^b - 1), or max(c / (2^(b-1) - 1), -1), in fp64 and rounded once; an accessor without a buffer view is zero
  // where its sparse part does not say otherwise. Error(bad_input): a component that is NaN or infinite where `numbers`
  // asks for finite ones, a buffer without data, sparse indices that do not increase, more data than the document's
  // budget.
  template <typename T>
  std::vector<T> decode(int accessor, Numbers numbers = Numbers::finite) const;

 private:
  // `stride` bytes from element to element, the first at `bytes`; every element is inside. Null: no data, all zero.
  struct View {
    const char* bytes = nullptr;
    std::size_t stride = 0;
    int missing_buffer = -1;  // the placeholder that the data should be in
  };
  struct Sparse {
    std::size_t count = 0;
    GltfComponent index_component = GltfComponent::uint32;
    View indices, values;
  };
  struct Accessor {
    GltfValue json;
    std::size_t count = 0;
    std::string type{};
    std::size_t width = 0;  // components an element
    GltfComponent component = GltfComponent::float32;
    bool normalized = false;
    View view{};
    Sparse sparse{};
  };

  Accessor check(const GltfValue& json) const;
  Sparse check_sparse(const GltfValue& json, const Accessor& base) const;
  // `packed`: bytes from element to element where the buffer view names no stride; `size`: bytes of one element.
  View check_view(const GltfValue& owner, std::size_t count, std::size_t packed, std::size_t size,
                  bool may_stride) const;
  void require_data(const View& view, const Accessor& accessor) const;

  const GltfDocument& document_;
  std::vector<Accessor> accessors_;
};

}  // namespace morphcl
