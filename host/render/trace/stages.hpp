// The stages of the pipeline with their matrices, as a convention writes them.
#pragma once

#include <vector>

#include "host/render/trace/step_chain.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

// Each stage goes on where `chain` stands.
TraceStage model_stage(const std::vector<TransformStep>& steps, const Convention& convention, StepChain& chain);
TraceStage view_stage(const CameraState& camera, const Convention& convention, StepChain& chain);
TraceStage projection_stage(const Projection& projection, double aspect, const Convention& convention,
                            StepChain& chain);
// `ndc` is clip space divided.
TraceStage division_stage(const TracePoint& clip, const TracePoint& ndc, const StepChain& chain);
// To pixels, y downwards; depth from 0 on the near plane to 1 on the far one.
TraceStage viewport_stage(int width, int height, const TracePoint& ndc, const Convention& convention,
                          const StepChain& chain);

// A point of object, world or eye space in the convention's handedness.
TracePoint handed(const Convention& convention, TracePoint point);

// Of an affine matrix, or of a projection as projection.hpp has them; nothing where there is none.
std::optional<glm::dmat4> pipeline_inverse(const glm::dmat4& matrix);

}  // namespace morphcl
