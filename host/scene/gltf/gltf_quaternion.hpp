// Rotations as glTF stores them: quaternions x y z w.
#pragma once

#include <optional>
#include <span>

namespace morphcl {

// Makes the quaternion of unit length, within 4u64 and with the same bits on every machine, and returns the length that
// it had. Where it has no direction (it is 0, or a component is not finite) nothing is changed or returned. The C
// library's hypot would do neither: its last bit depends on the processor.
std::optional<double> normalize_quaternion(std::span<double, 4> q);

}  // namespace morphcl
