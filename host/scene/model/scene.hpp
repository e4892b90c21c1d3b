// A scene: what is drawn, how it moves, and the image that is asked for. Importers make one, the plan reads it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "anim/timeline.hpp"
#include "host/geometry/mesh.hpp"
#include "host/math/depth_format.hpp"
#include "host/scene/model/frame_range.hpp"

namespace morphcl {

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
  Timeline timeline;            // timeline.weights has one entry an object
  ImageSettings image;
  double accuracy_pixels = 0;  // vertices are to be within this of their exact places; 0: fp32 will do
  std::vector<FrameRange> frames;
  std::vector<std::string> warnings;  // one line each: what the file holds that is not drawn
  std::string content_hash;           // hex xxh3-128 of every byte read for this scene: part of the fingerprint
};

// Cross-checks everything that a renderer relies on: indices, one weight list an object, finite values. Importers call
// it.
void validate(const Scene& scene);

}  // namespace morphcl
