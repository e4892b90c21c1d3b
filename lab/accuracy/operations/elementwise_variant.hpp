// A variant whose results are a function of the element's stored inputs alone, for the host's loop.
#pragma once

#include <array>
#include <utility>

#include "lab/accuracy/elementwise.hpp"
#include "lab/accuracy/planar_operation.hpp"

namespace morphcl::accuracy {

namespace elementwise_detail {

template <class Real, class Stored, class Function, std::size_t... P>
typename Variant<Real>::Run run(const Planes<Stored>& planes, const Function& function, std::index_sequence<P...>) {
  const std::array<const Stored*, sizeof...(P)> in = {planes.plane(P)...};
  return [in, function, count = planes.size()](Planes<Real>& results) {
    using Results = decltype(function(in[P][0]...));
    if constexpr (std::is_arithmetic_v<Results>) {
      Real* out = results.plane(0);
      for_each_element(count, [=](std::size_t i) { out[i] = static_cast<Real>(function(in[P][i]...)); });
    } else {
      constexpr std::size_t outs = std::tuple_size_v<Results>;
      std::array<Real*, outs> out;
      for (std::size_t r = 0; r < outs; ++r) out[r] = results.plane(r);
      for_each_element(count, [=](std::size_t i) {
        const Results value = function(in[P][i]...);
        for (std::size_t r = 0; r < outs; ++r) out[r][i] = static_cast<Real>(value[r]);
      });
    }
  };
}

}  // namespace elementwise_detail

// function(float...) -> number or array, one argument a plane.
template <std::size_t Inputs, class Function>
Variant<float> elementwise32(const std::string& name, const Function& function) {
  return {.name = name, .prepare = [function](const Batch& batch) {
            return elementwise_detail::run<float>(batch.stored, function, std::make_index_sequence<Inputs>());
          }};
}

// function(double...) -> number or array, one argument a plane, of the unrounded inputs.
template <std::size_t Inputs, class Function>
Variant<double> elementwise64(const std::string& name, const Function& function) {
  return {.name = name, .prepare = [function](const Batch& batch) {
            return elementwise_detail::run<double>(batch.truth, function, std::make_index_sequence<Inputs>());
          }};
}

// A function as a type of its own, which the loop is compiled for: through a pointer it would be called.
template <auto Function>
constexpr auto inlined = [](auto... arguments) { return Function(arguments...); };

// What morphcl itself computes.
template <class Real>
Variant<Real> shipped(Variant<Real> variant) {
  variant.ships = true;
  return variant;
}

// What calls functions of the C library that are not correctly rounded, and so is not the same everywhere.
template <class Real>
Variant<Real> by_c_library(Variant<Real> variant) {
  variant.c_library = true;
  return variant;
}

// With its twin on the device, which reads no constants.
inline Variant<float> with_kernel(Variant<float> variant, const std::string& program, const std::string& kernel) {
  variant.device = kernel_run(program, kernel, [](const Batch&) { return std::vector<double>(); });
  return variant;
}

}  // namespace morphcl::accuracy
