// What the renderer's kernels take, by name (kernels/layout.h says what is in them).
#pragma once

#include <string_view>

#include "host/device/device_buffer.hpp"
#include "host/render/frame/kernel_layout.hpp"

namespace morphcl::buffers {

struct Frame {
  using Element = layout::FrameConstants;
  static constexpr std::string_view name = "frame", type = "FrameConstants";
};
struct Draws {
  using Element = layout::DrawConstants;
  static constexpr std::string_view name = "draws", type = "DrawConstants";
};
struct Targets {
  using Element = layout::TargetConstants;
  static constexpr std::string_view name = "targets", type = "TargetConstants";
};
struct MeshData {
  using Element = float;
  static constexpr std::string_view name = "mesh_data", type = "float";
};
struct Indices {
  using Element = layout::uint;
  static constexpr std::string_view name = "indices", type = "uint";
};

struct Records {
  using Element = layout::Int4;
  static constexpr std::string_view type = "int4";
};
struct Vertices : Records {
  static constexpr std::string_view name = "vertices";
};
struct Attributes : Records {
  static constexpr std::string_view name = "attributes";
};
struct Colors : Records {
  static constexpr std::string_view name = "colors";
};
struct FaceColors : Records {
  static constexpr std::string_view name = "face_colors";
};

struct Clipped {
  using Element = layout::ClippedPrimitive;
  static constexpr std::string_view name = "clipped", type = "ClippedPrimitive";
};
struct FragmentKeys {
  using Element = layout::ulong;
  static constexpr std::string_view name = "fragment_keys", type = "ulong";
};
struct Bins {
  using Element = layout::BinsHeader;
  static constexpr std::string_view name = "bins", type = "BinsHeader";
};
struct Large {
  using Element = layout::LargeTriangle;
  static constexpr std::string_view name = "large", type = "LargeTriangle";
};

struct Picture {
  using Element = std::byte;
  static constexpr std::string_view name = "picture", type = "uchar";
};

}  // namespace morphcl::buffers
