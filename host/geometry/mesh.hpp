#pragma once

#include "morphcl/mesh.hpp"
