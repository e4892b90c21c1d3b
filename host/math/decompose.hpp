#pragma once

#include "morphcl/transform.hpp"
