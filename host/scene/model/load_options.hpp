#pragma once

#include "morphcl/scene.hpp"
