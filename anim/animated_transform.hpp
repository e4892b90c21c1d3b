#pragma once

#include "morphcl/animated_transform.hpp"
