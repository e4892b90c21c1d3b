// The built-in meshes that an object's table says more of than segments: surfaces of revolution and curves.
#pragma once

#include <string>
#include <string_view>

#include "host/scene/shot/shot_value.hpp"
#include "morphcl/mesh.hpp"

namespace morphcl {

// "revolution" or "curve".
bool is_formula_mesh(std::string_view name);

// The mesh of the table's keys mesh, segments, and profile or points. Error(bad_input) at what is wrong.
Mesh read_formula_mesh(const ShotTable& object);

// All numbers of profile and points as they were read, for those who compare tables; "" without them.
std::string formula_text(const ShotTable& object);

// Error(bad_input) where the table has the key of another mesh than its own.
void refuse_other_formulas(const ShotTable& object);

}  // namespace morphcl
