#pragma once

#include "morphcl/depth_format.hpp"
