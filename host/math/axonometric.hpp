#pragma once

#include "morphcl/camera.hpp"
