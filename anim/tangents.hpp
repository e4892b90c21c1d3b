#pragma once

#include "morphcl/track.hpp"
