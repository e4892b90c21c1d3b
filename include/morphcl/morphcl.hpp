// The whole library.
//
// A scene is loaded or built, a frame of it is planned, a renderer draws the plan (OpenCL device or plain C++
// reference, the same bits), and the frame is written; run() does that for a range of frames.
//
// In all headers: vectors are columns and spaces right-handed. Error(usage) in a comment means that an Error of that
// ErrorKind is thrown (error.hpp). u64 = 2^-53 and u32 = 2^-24 are the unit roundoffs of double and float, u that of
// the type at hand; errors of results are relative unless stated. An ulp is the distance between neighbouring numbers.
// "Kahan's difference of products" is a b - c d with fma (Jeannerod, Louvet and Muller 2013). An object is for one
// thread at a time while a member that is not const is called, unless its class says otherwise.
#pragma once

#include "morphcl/animated_transform.hpp"
#include "morphcl/batch.hpp"
#include "morphcl/camera.hpp"
#include "morphcl/channel.hpp"
#include "morphcl/collision.hpp"
#include "morphcl/convention.hpp"
#include "morphcl/depth_format.hpp"
#include "morphcl/error.hpp"
#include "morphcl/explain.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/frame.hpp"
#include "morphcl/geometry.hpp"
#include "morphcl/hidden_surfaces.hpp"
#include "morphcl/job.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/png.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/session.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/trace.hpp"
#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"
#include "morphcl/transform_2d.hpp"
#include "morphcl/version.hpp"
#include "morphcl/visibility.hpp"
