#pragma once

#include "morphcl/projection.hpp"
