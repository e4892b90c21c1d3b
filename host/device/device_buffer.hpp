// Buffers that know what they are to kernels: the name of the argument and the type of the elements.
//
//   using Vertices = Argument<layout::Int4, "vertices", "int4">;  // name and type as the kernels declare them
//   DeviceBuffer<Vertices> vertices(context);
//
// Buffers of different meaning are different types even where their elements are the same, and only elements of the
// right type go in and come out.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include "host/device/shared_buffer.hpp"

namespace morphcl {

// A text as a template argument.
template <std::size_t size>
struct Text {
  consteval Text(const char (&text)[size]) { std::copy_n(text, size, characters); }
  constexpr operator std::string_view() const { return {characters, size - 1}; }
  char characters[size];
};

template <class ElementType, Text argument_name, Text element_type>
struct Argument {
  using Element = ElementType;
  static constexpr std::string_view name = argument_name, type = element_type;
};

template <class T>
concept BufferMeaning = requires {
  typename T::Element;
  { T::name } -> std::convertible_to<std::string_view>;
  { T::type } -> std::convertible_to<std::string_view>;
} && std::is_trivially_copyable_v<typename T::Element> && std::is_standard_layout_v<typename T::Element>;

template <BufferMeaning Meaning>
class DeviceBuffer {
 public:
  using Element = typename Meaning::Element;

  explicit DeviceBuffer(cl::Context context) : memory_(std::move(context)) {}

  // As SharedBuffer::ensure: where it must grow, the content is lost. True: it has grown.
  bool ensure(std::size_t elements) { return ensure_bytes(elements * sizeof(Element)); }
  // Of buffers in which tables follow each other, told apart by offsets.
  bool ensure_bytes(std::size_t bytes) {
    const bool grows = bytes > memory_.capacity();
    memory_.ensure(bytes);
    return grows;
  }
  std::size_t capacity() const { return memory_.capacity(); }  // bytes
  const cl::Buffer& buffer() const { return memory_.buffer(); }

  Mapped<Element> map(const cl::CommandQueue& queue, std::size_t count) const {
    return memory_.map<Element>(queue, count);
  }
  Mapped<const Element> read(const cl::CommandQueue& queue, std::size_t count) const {
    return memory_.map<const Element>(queue, count);
  }

 private:
  SharedBuffer memory_;
};

// A buffer that somebody else made, under the meaning that it is said to have.
template <BufferMeaning Meaning>
class BufferAs {
 public:
  explicit BufferAs(cl::Buffer buffer) : buffer_(std::move(buffer)) {}
  const cl::Buffer& buffer() const { return buffer_; }

 private:
  cl::Buffer buffer_;
};

}  // namespace morphcl
