// The whole library.
//
// A scene is loaded or built (host/scene), a frame of it is planned (host/render/plan.hpp), a renderer draws the plan
// (OpenCL device or plain C++ reference, the same bits), and the frame is written (host/image); run() does that for a
// range of frames (host/job).
#pragma once

#include "anim/timeline.hpp"
#include "anim/track.hpp"
#include "host/batch/transform_buffers.hpp"
#include "host/batch/transform_reference.hpp"
#include "host/batch/transform_vertices.hpp"
#include "host/device/session.hpp"
#include "host/error.hpp"
#include "host/geometry/mesh.hpp"
#include "host/geometry/solids.hpp"
#include "host/image/exr_file.hpp"
#include "host/image/frame_buffer.hpp"
#include "host/job/render_job.hpp"
#include "host/math/angle.hpp"
#include "host/math/axonometric.hpp"
#include "host/math/composite_transform.hpp"
#include "host/math/convention.hpp"
#include "host/math/decompose.hpp"
#include "host/math/look_at.hpp"
#include "host/math/projection.hpp"
#include "host/math/seven_step_rotation.hpp"
#include "host/math/transform_2d.hpp"
#include "host/math/vanishing_point.hpp"
#include "host/math/viewport.hpp"
#include "host/render/device_renderer.hpp"
#include "host/render/plan.hpp"
#include "host/render/reference_renderer.hpp"
#include "host/render/renderer.hpp"
#include "host/scene/frame_range.hpp"
#include "host/scene/load_scene.hpp"
#include "host/scene/scene.hpp"
#include "host/version.hpp"
