#pragma once

#include "morphcl/transform_2d.hpp"
