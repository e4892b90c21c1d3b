#pragma once

#include "morphcl/solids.hpp"
