// trace() for an object by its number: names need not be unique.
#pragma once

#include "morphcl/trace.hpp"

namespace morphcl {

// request.object is not read.
Trace trace_object(const Scene& scene, std::int64_t frame, std::size_t object, const TraceRequest& request);

}  // namespace morphcl
