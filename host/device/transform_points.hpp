// Batch transforms on the device: points, vectors and normals, any number of them.
//
// The arrays are used in place (no copies on a CPU device); `out` may be the same arrays as `in`. The calls return when
// the results are in `out`. Results are the same bits on every device with Verdict::identical, as
// transform_points_reference.hpp computes them, as long as nothing overflows; inputs should be finite.
// Arrays that start at multiples of 64 bytes are written without being read first, which large batches gain from.
// Error(usage): sizes differ or arrays overlap (point_arrays.hpp). Error(internal, no_device): the device failed.
#pragma once

#include "host/device/point_arrays.hpp"
#include "host/device/session.hpp"

namespace morphcl {

// out = rows (x, y, z, 1), each coordinate as fma(x, m0, fma(y, m1, fma(z, m2, m3))): at most 3 roundings.
void transform_points(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);

// out = (X, Y, Z) / w with (X, Y, Z, w) = rows (x, y, z, 1). A point with w <= 0 has no image: +infinity, three times.
void project_points(Session& session, const ProjectiveRows& rows, const ConstPointArrays& in, const PointArrays& out);

// out = linear part of rows times (x, y, z), as fma(x, m0, fma(y, m1, z m2)); translations are ignored.
void transform_vectors(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);

// out = unit normals of the transformed surface: normal_rows(rows) times (x, y, z), normalised. `rows` is the matrix
// that the points are transformed with. Lengths from denormal to near overflow are safe; a normal of length 0, or one
// that the matrix takes to 0, gives 0.
void transform_normals(Session& session, const AffineRows& rows, const ConstPointArrays& in, const PointArrays& out);

}  // namespace morphcl
