// Meshes in device memory: every attribute as planes of floats padded to whole vertex groups, indices as planes of
// uints padded to whole primitive groups. A mesh is uploaded when a plan first draws it and stays until a plan of
// another planner comes: only plans of one planner promise that a mesh at the same address is the same mesh.
#pragma once

#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/render/device/buffers.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/kernel_layout.hpp"
#include "morphcl/session.hpp"

namespace morphcl {

// Offsets count floats (attributes) or uints (indices); layout::no_id: the mesh has no such attribute.
struct StoredMesh {
  glm::vec3 middle{0.0f};  // of the base's bounding box
  layout::uint vertex_groups = 0;
  layout::uint pitch = 0;  // floats from one plane to the next
  layout::uint positions = layout::no_id, normals = layout::no_id, colors = layout::no_id, uvs = layout::no_id;
  struct Target {
    layout::uint positions = layout::no_id, normals = layout::no_id, colors = layout::no_id;
  };
  std::vector<Target> targets;
  // Triangles and, if a draw asked for them, the edges that wireframe shows.
  struct Primitives {
    layout::uint count = 0, groups = 0;
    layout::uint indices = layout::no_id, pitch = 0;
  };
  Primitives triangles, edges;
};

class MeshStore {
 public:
  explicit MeshStore(std::shared_ptr<Session> session);

  // Makes sure that all meshes of the plan are on the device. Error(bad_input) when they exceed what the device can
  // allocate at once, with the numbers. Displaced positions are brought there too when they are new. True when the
  // meshes on the device are others than before, or elsewhere.
  bool require(const FramePlan& plan);

  const StoredMesh& stored(const Mesh& mesh) const { return stored_.at(&mesh); }
  // Where the plan's displaced positions of an object are, as floats in the mesh data.
  layout::uint displaced(std::uint32_t object) const { return displaced_.at({object, Frame::this_one}).positions; }
  // The same of the next frame, where the plan has them.
  layout::uint next_displaced(std::uint32_t object) const { return displaced_.at({object, Frame::next}).positions; }
  const DeviceBuffer<buffers::MeshData>& mesh_data() const { return data_; }
  const DeviceBuffer<buffers::Indices>& indices() const { return indices_; }

 private:
  enum class Frame { this_one, next };

  void upload();
  bool add_displaced(const std::vector<Draw>& draws, Frame frame);
  void upload_displaced(const std::vector<Draw>& draws, Frame frame);

  std::shared_ptr<Session> session_;
  std::uint64_t planner_ = 0;
  std::unordered_map<const Mesh*, StoredMesh> stored_;
  std::vector<const Mesh*> order_;
  std::unordered_map<const Mesh*, bool> wants_edges_;
  struct Displaced {
    const Mesh* mesh;
    layout::uint positions = layout::no_id;
    std::array<std::uint64_t, 2> hash{};  // of what is there
    bool uploaded = false;
  };
  std::map<std::pair<std::uint32_t, Frame>, Displaced> displaced_;  // by object
  std::vector<float> planes_;                                       // room for an object's positions
  bool wants_uvs_ = false;
  DeviceBuffer<buffers::MeshData> data_;
  DeviceBuffer<buffers::Indices> indices_;
};

}  // namespace morphcl
