// Colours as they are elsewhere, in what a shot has: linear light.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/scene/shot/shot_value.hpp"

namespace morphcl {

// "#ff8800", "#f80" and "ff8800" as the array to write instead: "[1, 0.2462, 0]". Nothing for other texts.
std::optional<std::string> linear_of_hex(std::string_view text);

// Refuses such a text; lets everything else pass.
void refuse_color_text(const ShotValue& color);

// Refuses an array that is most likely meant as sRGB from 0 to 255: integers up to 255, one of 16 or more. A colour as
// bright as that can still be had, with a point in its numbers.
void refuse_codes(const ShotValue& color);

}  // namespace morphcl
