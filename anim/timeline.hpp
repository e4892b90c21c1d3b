#pragma once

#include "morphcl/timeline.hpp"
