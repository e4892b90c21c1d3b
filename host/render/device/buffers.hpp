// What the renderer's kernels take, by name (kernels/layout.h says what is in them).
#pragma once

#include <cstddef>

#include "host/device/device_buffer.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl::buffers {

using Frame = Argument<layout::FrameConstants, "frame", "FrameConstants">;
using Draws = Argument<layout::DrawConstants, "draws", "DrawConstants">;
using Targets = Argument<layout::TargetConstants, "targets", "TargetConstants">;
using MeshData = Argument<float, "mesh_data", "float">;
using Indices = Argument<layout::uint, "indices", "uint">;

using Vertices = Argument<layout::Int4, "vertices", "int4">;
using Attributes = Argument<layout::Int4, "attributes", "int4">;
using Colors = Argument<layout::Int4, "colors", "int4">;
using FaceColors = Argument<layout::Int4, "face_colors", "int4">;

using Motion = Argument<layout::Int4, "motion", "int4">;

using Clipped = Argument<layout::ClippedPrimitive, "clipped", "ClippedPrimitive">;
using FragmentKeys = Argument<layout::ulong, "fragment_keys", "ulong">;
using SampleFragments = Argument<layout::SampleFragment, "sample_fragments", "SampleFragment">;
using Bins = Argument<layout::BinsHeader, "bins", "BinsHeader">;
using Large = Argument<layout::LargeTriangle, "large", "LargeTriangle">;

using Picture = Argument<std::byte, "picture", "uchar">;

}  // namespace morphcl::buffers
