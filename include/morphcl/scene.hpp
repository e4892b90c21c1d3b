// A scene: what is drawn, how it moves, and the image that is asked for. Made in code, or loaded from a shot or a
// model.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "morphcl/depth_format.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"

namespace [[gnu::visibility("default")]] morphcl {

// ---- frame range ----------------------------------------------------------------------------------------------------
//
// Frame ranges: which frames are asked for.

struct FrameRange {  // first, first + step, ... up to last
  std::int64_t first = 0, last = 0, step = 1;
};

constexpr std::int64_t max_frame_number = 1'000'000;
constexpr std::int64_t max_frame_count = 1'000'000;

// "7", "1-10", "1-10x2", commas between, spaces around them; negative numbers are allowed ("-5--1"). Error(usage)
// explains what is wrong: anything else, last < first, a step below 1, |frame| > max_frame_number, more than 10,000
// parts. A ':' is refused with the reason.
std::vector<FrameRange> parse_frame_range(const std::string& text);

// Every frame once, in ascending order. Error(usage): no frame, the ranges together list more than max_frame_count, or
// |frame| > max_frame_number.
std::vector<std::int64_t> frame_numbers(const std::vector<FrameRange>& ranges);

// ---- scene ----------------------------------------------------------------------------------------------------------

enum class Shading { flat, smooth, unlit, wireframe };

struct Material {
  glm::dvec4 base_color{0.8, 0.8, 0.8, 1.0};  // linear
  Shading shading = Shading::smooth;          // smooth falls back to flat on a mesh without normals
  bool double_sided = false;                  // false: back faces are culled
};

struct Object {
  std::string name;
  int mesh = 0;  // index into Scene::meshes
  int node = 0;  // index into Timeline::nodes
  Material material;
  MorphWeights morph = {};  // one weight a target of the mesh
};

constexpr int max_image_size = 16384;

struct ImageSettings {
  int width = 1920, height = 1080;  // pixels, 1 to max_image_size
  bool color = true;                // RGBA half
  bool depth = true;                // Z float
  std::string compression = "zip";
  DepthFormat depth_format = DepthFormat::reversed_float;  // of the buffer that decides what is nearest
};

struct Scene {
  std::string name;  // stem of the file, used for the default output pattern
  std::vector<Mesh> meshes;
  std::vector<Object> objects;  // drawn in this order; equal depths: the earlier one wins
  Timeline timeline;
  ImageSettings image;
  double accuracy_pixels = 0;  // vertices are to be within this of their exact places; 0: fp32 will do
  std::vector<FrameRange> frames;
  std::vector<std::string> warnings;  // one line each: what the file holds that is not drawn
  std::string content_hash;           // hex xxh3-128 of every byte read for this scene; "" for one made in code

  // An object with a mesh and a node of its own, placed in the world, all morph weights 0. Returns its index.
  int add_object(std::string object_name, Mesh mesh, const CompositeTransform& placing = {});
  // One more object of a mesh that the scene has. Error(usage) when it does not have it.
  int add_object(std::string object_name, int mesh, const CompositeTransform& placing = {});

  // From now on the track, of width 1, is the weight of the object's morph target of that name. Error(usage) when there
  // is no such object or target, naming those there are, or when the track has another width.
  void morph(int object, std::string_view target, Track track);
};

// Checks everything that renderers rely on: indices, one weight a target, finite values. Error(bad_input) with the
// place. A planner does it once, when it takes the scene; load_scene() has done it.
void validate(const Scene& scene);

// ---- loading --------------------------------------------------------------------------------------------------------

// What the caller decides instead of the file.
struct LoadOptions {
  bool allow_outside = false;        // files may lie outside the folder of the file that names them
  std::optional<TimeBase> fps;       // frames per second
  std::optional<int> width, height;  // pixels; the fitted camera frames for this size
};

// By the extension of `path`, in any case: .toml is a shot; .gltf, .glb and .obj are models, drawn as a shot would draw
// them with nothing but the object: camera and lights of the file, else the fitted camera and the key light; frames 0
// to the last one at or before the last key.
//
// The result is valid. Errors: cannot_read when the file is missing or unreadable,
// bad_input when it or what it names is wrong, usage for another extension or options out of range.
Scene load_scene(const std::string& path, const LoadOptions& options = {});

}  // namespace morphcl
