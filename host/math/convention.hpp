#pragma once

#include "morphcl/convention.hpp"
