// The OpenCL C++ headers with the settings that every file must share.
#pragma once

#include "morphcl/opencl_interop.hpp"
