// The [object.elastic] table of a shot file.
#pragma once

#include "anim/elastic.hpp"
#include "host/scene/shot/shot_value.hpp"

namespace morphcl {

Elastic read_elastic(const ShotValue& value);

}  // namespace morphcl
