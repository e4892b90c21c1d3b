// How a frame's hidden surfaces are found. Every method gives the picture of the z-buffer, pixel for pixel; the others
// are there to be looked at and compared, and are drawn by the reference renderer. docs/visibility.md sets them side by
// side.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#pragma GCC visibility push(default)
namespace morphcl {

enum class VisibilityMethod {
  z_buffer,
  painter,  // Newell, Newell and Sancha: sorted by depth, split where surfaces have no order
  bsp,      // Fuchs, Kedem and Naylor: the order of a binary space partition
  warnock,  // windows that are divided in four
  watkins   // scan lines and their sample spans
};
constexpr std::array<VisibilityMethod, 5> visibility_methods = {VisibilityMethod::z_buffer, VisibilityMethod::painter,
                                                                VisibilityMethod::bsp, VisibilityMethod::warnock,
                                                                VisibilityMethod::watkins};

// "z-buffer", "painter", "bsp", "warnock", "watkins": the names of shot files and options.
std::string_view name_of(VisibilityMethod method);
std::optional<VisibilityMethod> visibility_method_named(std::string_view name);

// Pieces that painter and bsp may split a frame's triangles to; more are refused.
constexpr std::size_t max_visibility_pieces = 1'000'000;

}  // namespace morphcl
#pragma GCC visibility pop
