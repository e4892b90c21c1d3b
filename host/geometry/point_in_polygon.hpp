#pragma once

#include "morphcl/predicates.hpp"
