// Inverses of affine maps, and the matrix that carries normals.
//
// Matrices are column-vector affine maps (last row 0 0 0 1) of finite entries. Cofactors are Kahan differences of
// products (host/math/kahan.hpp) of columns scaled by powers of two, so that scales from 1e-300 to 1e300 neither
// overflow nor vanish.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace morphcl {

// Empty when the map is singular: when its determinant cannot be told from 0 after the rounding of its own evaluation
// (8u times the product of the lengths of the columns), or when the inverse does not fit into fp64.
std::optional<glm::dmat4> try_affine_inverse(const glm::dmat4& affine);

// The same; throws Error(usage) where there is no inverse.
glm::dmat4 affine_inverse(const glm::dmat4& affine);

// Transpose of the rotation, translation -R^T t. The upper 3x3 must be orthonormal; this is not tested.
glm::dmat4 rigid_inverse(const glm::dmat4& rigid);

// The inverse transpose of the upper 3x3 but for a positive factor that brings its largest entry into [0.5, 1): for
// normals, which are normalised afterwards. Made of cofactors without a division, so it exists for singular maps too: a
// surface that is flattened onto a plane gets that plane's normal. All zero when the map leaves a line or a point. A
// mirroring map keeps outward normals outward.
glm::dmat3 normal_matrix(const glm::dmat4& affine);

}  // namespace morphcl
