// The plan of a frame as renderers take it: what is drawn, from where, and which steps this frame needs.
//
// Everything that needs fp64 or trigonometry happened before; what stands here is rounded to fp32 once, the same for
// device and reference.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "host/render/frame/active_targets.hpp"
#include "host/render/frame/camera_constants.hpp"
#include "host/render/frame/depth_buffer.hpp"
#include "host/render/frame/displaced_positions.hpp"
#include "host/render/frame/vertex_accuracy.hpp"
#include "morphcl/exr.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/visibility.hpp"

namespace morphcl {

// What channel N takes: the mesh's normals, or those of its faces. Nothing of lines, or where N is not asked for.
enum class NormalSource : std::uint8_t { none, vertices, faces };

struct Draw {
  const Mesh* mesh = nullptr;
  std::uint32_t object = 0;  // index into the scene's objects
  Shading shading = Shading::flat;
  bool double_sided = false;
  bool mirrored = false;              // the object's transform has a negative determinant: front faces turn clockwise
  std::array<Row, 4> object_to_clip;  // rows x, y, depth, w
  std::array<Row, 3> object_to_eye;   // for lighting: positions
  // Inverse transpose, scaled by a power of two; of draws that are lit or show normals.
  std::array<std::array<float, 3>, 3> normal_to_eye{};
  std::array<float, 4> base_color;
  std::uint32_t line_width = 1u << 8;  // of a wireframe: sub-pixels
  bool vertex_colors = false;
  // Its alpha is less than 1 somewhere: what lies behind shows through. Then base_color's alpha times the vertices', or
  // where alpha_cutoff is not negative 1 or 0: at least as much, or less.
  bool blended = false;
  float alpha_cutoff = -1;
  bool lit_per_pixel = false;  // of a flat draw: its faces' normals meet the light at each pixel, not at their centres
  ActiveTargets targets;       // only those with a weight other than 0
  std::shared_ptr<const VertexAccuracy> accuracy;  // where the scene states an error; none: plain vertices
  // In place of the morphed positions; then targets move normals and colours only. Null for most objects.
  std::shared_ptr<const DisplacedPositions> displaced;
  // What channels show of it; 0 where the plan's channels do not ask for it.
  std::uint32_t object_id = 0, material_id = 0;
  float crypto_object = 0, crypto_material = 0;  // ids of the names (host/cryptomatte_id.hpp)
  std::array<float, 3> albedo{};                 // base colour without light
  NormalSource normals = NormalSource::none;
  bool moves = false;  // some vertex is elsewhere on the picture in the next frame; where velocity is asked for
};

struct EyeLight {
  LightKind kind;
  std::array<float, 3> vector;  // eye space: unit direction towards the light, or position
  std::array<float, 3> color;
  bool falloff;
  // Of a spot light, else cone_scale is 0: the unit vector along its beam, and what makes a cosine c of the angle from
  // it the root of the light's share, cone_scale * c + cone_offset clamped to 0 to 1.
  std::array<float, 3> beam{};
  float cone_scale = 0, cone_offset = 0;
};

// What a row of the picture shows where nothing is drawn: the halves of R, G, B, A.
using BackgroundRow = std::array<std::uint16_t, 4>;

struct FramePlan {
  // Which planner made it: plans of one planner share their meshes, which then do not change.
  std::uint64_t planner = 0;
  bool alone = false;  // its planner makes no other
  std::int64_t frame = 0, fps_numerator = 0, fps_denominator = 1;
  int width = 0, height = 0;
  ChannelSet channels = default_channels;
  int samples = 1;  // a pixel, of which its colour and alpha are the mean; 1 where no channel depends on them
  std::vector<Draw> draws;
  // For velocity: the same draws in the frame with the next number, as far as it says where vertices are. Else empty.
  std::vector<Draw> next_draws;
  // Not 0: plans of one planner with the same number have the same draws, but for their targets' weights.
  std::uint64_t draws_version = 0;
  std::vector<EyeLight> lights;
  std::array<float, 3> ambient{};
  CameraConstants camera{};
  DepthFormat depth_format = DepthFormat::reversed_float;    // of the buffer by which renderers tell what is nearest
  VisibilityMethod visibility = VisibilityMethod::z_buffer;  // another one: the reference draws
  bool clips = true;              // false: nothing comes near a clip plane, the clip stage is left out
  bool divides = true;            // false: w is 1 at every vertex, nothing is divided by it
  bool tests_depth = true;        // false: no pixel centre is covered twice, what comes is not compared
  bool blends = false;            // some draw is blended
  bool keeps_vertices = true;     // a draw that is as it was in the frame drawn before keeps its vertices
  bool keeps_blank_tiles = true;  // tiles that were and stay background are not written again
  std::shared_ptr<const std::vector<BackgroundRow>> background;  // of each row; null: 0 in all four
  std::array<Row, 3> eye_to_world{};                             // where N or P is asked for
  // For the image's attributes.
  glm::dmat4 world_to_eye{1.0}, world_to_ndc{1.0};
  ChannelNames channel_names = ChannelNames::plain;
  std::shared_ptr<const CryptomatteManifests> manifests;  // null without Cryptomatte

  bool has(Channel channel) const { return channels.contains(channel); }
  bool has_color() const { return has(Channel::color); }
  bool has_depth() const { return has(Channel::depth); }
};

}  // namespace morphcl
