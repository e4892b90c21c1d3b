#pragma once

#include "morphcl/numerics.hpp"
