// Sides that things are looked at from, by their names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "morphcl/camera.hpp"

namespace morphcl {

inline constexpr std::array<std::string_view, 7> view_names = {"three_quarter", "front", "back",  "left",
                                                               "right",         "top",   "bottom"};

// The first, "three_quarter", is from (1, 0.8, 1.7), y up (not at right angles to it); the others are the views of
// technical drawing (PrincipalView).
std::optional<ViewDirection> view_named(std::string_view name);

// The same; Error(usage) lists the views where there is none of that name.
ViewDirection needed_view(std::string_view name);

// `there is no view "x"; views are a, b, c`.
std::string no_such_view(std::string_view name);

}  // namespace morphcl
