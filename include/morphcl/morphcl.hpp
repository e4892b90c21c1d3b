// The whole library.
//
// A scene is loaded or built, a frame of it is planned, a renderer draws the plan (OpenCL device or plain C++
// reference, the same bits), and the frame is written; run() does that for a range of frames.
#pragma once

#include "morphcl/animated_transform.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/convention.hpp"
#include "morphcl/depth_format.hpp"
#include "morphcl/error.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/hidden_surfaces.hpp"
#include "morphcl/job.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/predicates.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/session.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"
#include "morphcl/transform_2d.hpp"
#include "morphcl/version.hpp"
