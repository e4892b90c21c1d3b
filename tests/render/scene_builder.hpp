// Small steps for building test scenes.
#pragma once

#include "morphcl/scene.hpp"

namespace morphcl::test {

class SceneBuilder {
 public:
  SceneBuilder(int width, int height) {
    scene_.image.width = width;
    scene_.image.height = height;
    Light key;
    key.vector = {0.4, 0.7, 0.9};
    scene_.timeline.lights.push_back(key);
    scene_.frames = {{0, 0, 1}};
  }

  // Adds an object; returns its index.
  int add(Mesh mesh, Shading shading, const glm::dmat4& transform = glm::dmat4(1.0),
          const glm::dvec4& color = {0.8, 0.5, 0.3, 1}, bool double_sided = false) {
    Object object;
    object.name = "object " + std::to_string(scene_.objects.size());
    object.mesh = static_cast<int>(scene_.meshes.size());
    object.node = static_cast<int>(scene_.timeline.nodes.size());
    object.material = {color, shading, double_sided};
    Node node;
    node.static_transform = transform;
    scene_.timeline.nodes.push_back(node);
    object.morph.weights.assign(mesh.targets.size(), 0.0);
    scene_.meshes.push_back(std::move(mesh));
    scene_.objects.push_back(object);
    return object.mesh;
  }

  SceneBuilder& look(const glm::dvec3& eye, const glm::dvec3& target = {0, 0, 0}) {
    scene_.timeline.camera.eye = eye;
    scene_.timeline.camera.target = target;
    return *this;
  }
  SceneBuilder& project(const Projection& projection) {
    scene_.timeline.camera.projection = projection;
    return *this;
  }
  SceneBuilder& weight(int object, double value, int target = 0) {
    scene_.objects[object].morph.weights[target] = value;
    return *this;
  }
  SceneBuilder& point_light(const glm::dvec3& position, const glm::dvec3& color, bool falloff) {
    Light light;
    light.kind = LightKind::point;
    light.vector = position;
    light.color = color;
    light.falloff = falloff;
    scene_.timeline.lights.push_back(light);
    return *this;
  }
  SceneBuilder& no_lights() {
    scene_.timeline.lights.clear();
    return *this;
  }
  Scene& scene() { return scene_; }

 private:
  Scene scene_;
};

inline glm::dmat4 place(const glm::dvec3& position, double scale = 1.0) {
  glm::dmat4 m(scale);
  m[3] = glm::dvec4(position, 1.0);
  return m;
}

}  // namespace morphcl::test
