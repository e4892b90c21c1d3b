// kernels/camera.h for the host: one struct from the plan to the kernels.
#pragma once

namespace morphcl {

namespace layout {
#include "kernels/camera.h"
}

using CameraConstants = layout::CameraConstants;
static_assert(sizeof(CameraConstants) == 4 * 19);

}  // namespace morphcl
