// Kernel launches by name: launch(queue, kernel, global, local, arguments...), the arguments in any order.
//
// A buffer goes to the kernel's argument of its meaning's name (device_buffer.hpp); values and local memory say the
// name:
//   launch(queue, fill, cl::NDRange(64), cl::NDRange(16), Named{"value", cl_int{7}}, buffer);
// That the kernel has an argument of this name and element type, and that each of its arguments is given once, is
// checked before anything runs. What is no buffer with a meaning and no named value does not compile: no bare buffers,
// no host pointers, no bool, which OpenCL does not pass.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <type_traits>

#include "host/device/device_buffer.hpp"
#include "host/device/kernel.hpp"

namespace morphcl {

template <class T>
concept KernelValue =
    std::is_trivially_copyable_v<T> && std::is_standard_layout_v<T> && !std::is_pointer_v<T> && !std::same_as<T, bool>;

namespace launch_detail {

// As kernels spell it; "" of what only a kernel's source knows, structs.
template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::same_as<T, cl_int>) return "int";
  if constexpr (std::same_as<T, cl_uint>) return "uint";
  if constexpr (std::same_as<T, cl_ulong>) return "ulong";
  if constexpr (std::same_as<T, float>) return "float";
  if constexpr (std::same_as<T, double>) return "double";
  return "";
}

}  // namespace launch_detail

// A value and the name of the kernel's argument that it is for; of a struct the name of its type in the kernel too.
template <KernelValue T>
struct Named {
  static constexpr std::string_view known_type = launch_detail::type_name<T>();

  Named(std::string_view argument, T its_value)
    requires(!known_type.empty())
      : name(argument), value(its_value), type(known_type) {}
  Named(std::string_view argument, T its_value, std::string_view its_type)
    requires(known_type.empty())
      : name(argument), value(its_value), type(its_type) {}

  std::string_view name;
  T value;
  std::string_view type;
};

struct LocalMemory {
  std::string_view name;
  std::size_t bytes;
};

namespace launch_detail {

// What one argument is given: the memory behind `value`, or with no value that much local memory.
struct Binding {
  std::string_view name;
  std::string_view type;  // "": of local memory, which has none
  const void* value;
  std::size_t bytes;
};

template <class T>
struct IsBuffer : std::false_type {};
template <class Meaning>
struct IsBuffer<DeviceBuffer<Meaning>> : std::true_type {
  using Of = Meaning;
};
template <class Meaning>
struct IsBuffer<BufferAs<Meaning>> : std::true_type {
  using Of = Meaning;
};

template <class T>
  requires IsBuffer<T>::value
Binding binding(const T& buffer) {
  using Meaning = typename IsBuffer<T>::Of;
  return {Meaning::name, Meaning::type, &buffer.buffer()(), sizeof(cl_mem)};
}
template <class T>
Binding binding(const Named<T>& named) {
  return {named.name, named.type, &named.value, sizeof(T)};
}
inline Binding binding(const LocalMemory& memory) { return {memory.name, "", nullptr, memory.bytes}; }

void launch(const cl::CommandQueue& queue, const Kernel& kernel, const cl::NDRange& offset, const cl::NDRange& global,
            const cl::NDRange& local, std::span<const Binding> bindings);

}  // namespace launch_detail

template <class T>
concept Launchable = requires(const T& argument) {
  { launch_detail::binding(argument) } -> std::same_as<launch_detail::Binding>;
};

// Enqueues `kernel` over `global` work-items in groups of `local`, which must divide it; does nothing if `global` is
// empty. Error(internal), naming kernel and argument: the kernel has no argument of a name, or of another type; one is
// missing, or given twice. Not for two threads with one kernel at a time.
template <Launchable... Arguments>
void launch(const cl::CommandQueue& queue, const Kernel& kernel, const cl::NDRange& global, const cl::NDRange& local,
            const Arguments&... arguments) {
  const std::array<launch_detail::Binding, sizeof...(Arguments)> bindings{launch_detail::binding(arguments)...};
  launch_detail::launch(queue, kernel, cl::NullRange, global, local, bindings);
}

// The same, with work-items that are numbered from `first` on.
struct FirstItem {
  std::size_t number;
};
template <Launchable... Arguments>
void launch(const cl::CommandQueue& queue, const Kernel& kernel, FirstItem first, const cl::NDRange& global,
            const cl::NDRange& local, const Arguments&... arguments) {
  const std::array<launch_detail::Binding, sizeof...(Arguments)> bindings{launch_detail::binding(arguments)...};
  const cl::NDRange offset = first.number == 0 ? cl::NullRange : cl::NDRange(first.number);
  launch_detail::launch(queue, kernel, offset, global, local, bindings);
}

}  // namespace morphcl
