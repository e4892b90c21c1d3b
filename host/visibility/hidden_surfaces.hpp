#pragma once

#include "morphcl/hidden_surfaces.hpp"
