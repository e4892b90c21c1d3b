#pragma once

#include "morphcl/rotation.hpp"
