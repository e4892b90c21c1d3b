#pragma once

#include "morphcl/error.hpp"
