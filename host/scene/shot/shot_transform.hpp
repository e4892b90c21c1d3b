// The [[object.transform]] tables of a shot file.
#pragma once

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

// Appends the step that `step`, a table with exactly one key, names.
void read_transform_step(const ShotValue& step, CompositeTransform& transform);

}  // namespace morphcl
