// A scene: what is drawn, how it moves, and the image that is asked for. Made in code, or loaded from a shot or a
// model.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "morphcl/channel.hpp"
#include "morphcl/depth_format.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/timeline.hpp"
#include "morphcl/track.hpp"
#include "morphcl/transform.hpp"
#include "morphcl/visibility.hpp"

#pragma GCC visibility push(default)
namespace morphcl {

// ---- frame range ----------------------------------------------------------------------------------------------------

struct FrameRange {  // first, first + step, ... up to last, which is included if it is met
  std::int64_t first = 0, last = 0, step = 1;
};

constexpr std::int64_t max_frame_number = 1'000'000;
constexpr std::int64_t max_frame_count = 1'000'000;

// "7", "1-10", "1-10x2", commas between, spaces around them; negative numbers are allowed ("-5--1"). Error(usage)
// explains what is wrong: anything else, last < first, a step below 1, |frame| > max_frame_number, more than 10,000
// parts. A ':' is refused with the reason.
std::vector<FrameRange> parse_frame_range(const std::string& text);

// Every frame once, in ascending order. Error(usage): no frame, the ranges together list more than max_frame_count, a
// step below 1, or |frame| > max_frame_number.
std::vector<std::int64_t> frame_numbers(const std::vector<FrameRange>& ranges);

// ---- scene ----------------------------------------------------------------------------------------------------------

// flat: lit once a face, at its centre. smooth: lit at each pixel, with interpolated normals. Both are diffuse, see
// Light. unlit: base colour times vertex colours. wireframe: lines in the base colour alone.
enum class Shading { flat, smooth, unlit, wireframe };

// What becomes of alpha, that of the base colour times that of the vertices. blend: what lies behind shows through
// where it is less than 1; exactly so in each sample, whatever the order of objects. mask: the surface is there, and
// opaque, where alpha is at least Material::alpha_cutoff. opaque: alpha is not used.
enum class AlphaMode { blend, mask, opaque };

struct Material {
  glm::dvec4 base_color{0.8, 0.8, 0.8, 1.0};  // linear; alpha from 0 to 1, colours are not multiplied by it
  Shading shading = Shading::smooth;          // smooth on a mesh without normals: each face has its own, lit per pixel
  bool double_sided = false;                  // false: back faces are culled; true: drawn, and lit from their side
  double line_width = 1;                      // of wireframe, pixels, more than 0 to max_line_width
  std::string name = {};                      // "": the object's; materials of one name are one (material_names())
  AlphaMode alpha_mode = AlphaMode::blend;
  double alpha_cutoff = 0.5;  // of AlphaMode::mask
  // Moves red, green and blue of base_color, of width 4 alpha too. What it overshoots to is brought back to 0 or more,
  // alpha to 0 to 1.
  Track base_color_track = {};
};
constexpr double max_line_width = 256;

struct Object {
  std::string name;
  int mesh = 0;  // index into Scene::meshes
  int node = 0;  // index into Timeline::nodes
  Material material;
  MorphWeights morph = {};  // as many weights as the mesh has targets
};

constexpr int max_image_size = 16384;

// What shows where nothing is drawn: scene-linear colours of the picture's upper and lower edge, and in between a row's
// share of both; each component 0 to max_background, the largest half.
struct Background {
  glm::dvec3 top{0.0}, bottom{0.0};
};
constexpr double max_background = 65504;

// Samples a pixel that a picture may have.
constexpr std::array<int, 5> sample_counts = {1, 2, 4, 8, 16};

struct ImageSettings {
  int width = 1920, height = 1080;                         // pixels, 1 to max_image_size
  ChannelSet channels = default_channels;                  // at least one
  ChannelNames channel_names = ChannelNames::plain;        // what EXR files call the channels' planes
  std::string compression = "zip";                         // one of compression_names() (exr.hpp)
  DepthFormat depth_format = DepthFormat::reversed_float;  // of the buffer that decides what is nearest
  std::optional<Background> background = std::nullopt;     // with alpha 1; none: colour and alpha are 0 there
  int samples = 1;  // a pixel, of sample_counts: its colour and alpha are their mean. Z is that of the pixel's centre
  // The relative error of Z that EXR files may have, so that they are smaller (round_depth() in frame.hpp); 0: none.
  // At most max_relative_error (numerics.hpp), and only beside Z. Renderers draw Z as it is.
  double z_error = 0;
  double p_error = 0;  // the same of each component of P, relative to itself (round_position()), beside P
  double n_error = 0;  // of each component of N, absolute, at most max_absolute_error (round_normal()), beside N
  VisibilityMethod visibility = VisibilityMethod::z_buffer;  // others take one sample a pixel; the same pixels

  bool has_color() const { return channels.contains(Channel::color); }
  bool has_depth() const { return channels.contains(Channel::depth); }
};

// Error(usage) where another method than the z-buffer is to find what several samples a pixel show.
void check_visibility(const ImageSettings& image);

// Something of which a model file may hold several; one is used. Animations that move different things are used
// together.
struct ModelPart {
  enum class Kind { animation, camera, scene };
  std::string model;  // the file
  Kind kind = Kind::animation;
  int index = 0;  // in the file
  std::string name;
  double seconds = 0;  // an animation's last key
  bool used = false;
};

struct Scene {
  std::string name;  // stem of the file, used for the default output pattern
  std::vector<Mesh> meshes;
  // Drawn in this order. Equal depths: of opaque surfaces the earlier one shows, a transparent one lies over all
  // before.
  std::vector<Object> objects;
  Timeline timeline;
  ImageSettings image;
  // The error of a vertex's place in the picture, in pixels, that plans are to keep; 0: none is stated, vertices are
  // plain fp32. Where nothing is known to keep it the best is done, and explain() says so.
  double accuracy_pixels = 0;
  std::vector<FrameRange> frames;     // for run(), unless the job lists its own; empty: none
  std::vector<ModelPart> parts;       // of the model files that were read
  std::vector<std::string> warnings;  // one line each: what the file holds that is not drawn
  std::string content_hash;           // hex xxh3-128 of every byte read for this scene; "" for one made in code
  std::vector<std::string> inputs;    // paths of the files that were read; a job does not write over them

  // An object with a mesh and a root node of its own, whose static_transform is placing.matrix(); all morph weights are
  // 0. Returns the object's index. Error(usage) when the matrix overflows.
  int add_object(std::string object_name, Mesh mesh, const CompositeTransform& placing = {});
  // One more object of a mesh that the scene has. Error(usage) when it does not have it.
  int add_object(std::string object_name, int mesh, const CompositeTransform& placing = {});

  // From now on the track, of width 1, is the weight of the object's morph target of that name. Error(usage) when there
  // is no such object or target, naming those there are, or when the track has another width. A later track of the same
  // target overrides an earlier one.
  void morph(int object, std::string_view target, Track track);
};

// The distinct names of the objects' materials, in the order of their first use: material_id i + 1 is the i-th of them.
// A material without a name has its object's.
std::vector<std::string> material_names(const Scene& scene);

// Checks everything that renderers rely on: indices, one weight a target, finite values. Error(bad_input) with the
// place; Error(usage) for `frames`, as frame_numbers() has it. A planner does it once, when it takes the scene;
// load_scene() has done it. run() checks the compression's name.
void validate(const Scene& scene);

// ---- loading --------------------------------------------------------------------------------------------------------

// What the caller decides instead of the file.
struct LoadOptions {
  bool allow_outside = false;                  // files may lie outside the folder of the file that names them
  std::optional<TimeBase> fps = {};            // overrides the file's frames per second; 25 where neither says
  std::optional<int> width = {}, height = {};  // pixels; override the file's
  // Of a glTF model: by name, else by the file's index from 0. Otherwise the first animation is played, all of them
  // when no two move the same; the camera is the first of the drawn nodes; the scene is the file's own, else its first.
  // A shot says so itself, for each object.
  std::optional<std::string> animation = {}, camera = {}, scene = {};
  // The side that a fitted camera looks from: three_quarter, front, back, left, right, top or bottom; otherwise what
  // the shot's [camera] says, else three_quarter. A model's own camera is not used then. Error(usage) for another name,
  // beside `camera`, and for a shot that says itself where its camera stands.
  std::optional<std::string> view = {};
  // Set by another thread or a signal: loading ends with Error(interrupted). It has to outlive load_scene().
  const std::atomic<bool>* stop = nullptr;
};

// By the extension of `path`, in any case: .toml is a shot; .gltf, .glb and .obj are models, drawn as a shot would draw
// them with nothing but the object: camera and lights of the file, else the fitted camera and the default lights;
// frames 0 to the last one at or before the last key. The fitted camera is a perspective of 45 degrees from the
// direction (1, 0.8, 1.7); what is drawn, at all frames together, lies in the middle of the image and fills 80 % of its
// width or height. The default lights are white: key, fill and a hemisphere of sky and ground (docs/shot-file.md).
//
// The result is valid. Errors: cannot_read when the file is missing or unreadable, bad_input when it or what it names
// is wrong, usage for another extension or options out of range.
Scene load_scene(const std::string& path, const LoadOptions& options = {});

}  // namespace morphcl
#pragma GCC visibility pop
