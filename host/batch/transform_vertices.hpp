// Batch transforms of vertices in the host's memory, any number of them, on a device.
//
// The arrays are used where they lie (no copies on a CPU device); `out` may be the same arrays as `in`. The call
// returns when the results are in `out`. They are the same bits on every device with Verdict::identical, as
// transform_reference() computes them; batches of fewer than 8192 vertices are computed by it, in about the time that
// the launch of a kernel takes.
//
// Large batches are written past the cache from the first result on that starts a cache line (64 bytes). That takes
// arrays of `separate` that all start at the same offset in their lines, as large arrays from one allocator do, and
// xyzw records of which one starts a line (all that are aligned to their size); other batches lose about a third of
// their speed.
#pragma once

#include <type_traits>

#include "host/batch/transform.hpp"
#include "host/batch/vertices.hpp"
#include "host/device/session.hpp"

namespace morphcl {

// Error(usage): `in`, `out` and the choice do not fit (vertices.hpp, transform.hpp), or a vertex asks for a matrix past
// the last one: it becomes NaN, all others are transformed. Error(no_device): Real is double and the device has none,
// or the device failed; Error(internal) likewise.
template <class Real>
void transform_vertices(Session& session, const Transform<Real>& transform,
                        const Vertices<const std::type_identity_t<Real>>& in,
                        const Vertices<std::type_identity_t<Real>>& out,
                        const MatrixChoice<std::type_identity_t<Real>>& choice = {});

}  // namespace morphcl
