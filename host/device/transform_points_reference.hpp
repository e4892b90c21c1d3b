// The batch transforms of transform_points.hpp in plain loops on the host: the same contract and the same bits.
#pragma once

#include "host/device/point_arrays.hpp"

namespace morphcl {

void transform_points_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);
void project_points_reference(const ProjectiveRows& rows, const ConstPointArrays& in, const PointArrays& out);
void transform_vectors_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);
void transform_normals_reference(const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);

}  // namespace morphcl
