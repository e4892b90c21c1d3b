#include "host/render/device/mesh_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/device/session_access.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t padding = layout::lanes;

std::size_t padded(std::size_t count) { return (count + padding - 1) / padding * padding; }

// Hands out room in a buffer that is filled later. Offsets mean nothing until check() has passed.
class Allocation {
 public:
  layout::uint take(std::size_t elements) {
    const std::size_t at = size_;
    size_ += elements;
    return static_cast<layout::uint>(at);
  }
  // Error(bad_input) when it is more than the device allocates at once, or than offsets can say.
  void check(const char* what, std::size_t limit_bytes) const {
    const std::size_t max_bytes = std::min(limit_bytes, std::size_t{layout::no_id} * 4);
    if (size_ * 4 <= max_bytes) return;
    constexpr double mebibyte = 1 << 20;
    throw Error(
        ErrorKind::bad_input, "",
        fmt::format("the meshes' {} take {:.0f} MiB, and the device allocates at most {:.0f} MiB at once; use "
                    "fewer vertices or morph targets, or another device",
                    what, static_cast<double>(size_) * 4 / mebibyte, static_cast<double>(max_bytes) / mebibyte));
  }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
};

template <class Vector>
void write_planes(const std::vector<Vector>& values, std::size_t pitch, float* out) {
  for (int component = 0; component < Vector::length(); ++component) {
    float* plane = out + component * pitch;
    for (std::size_t i = 0; i < values.size(); ++i) plane[i] = values[i][component];
    std::fill(plane + values.size(), plane + pitch, plane[values.size() - 1]);
  }
}

StoredMesh::Primitives place_primitives(std::size_t count, Allocation& indices) {
  StoredMesh::Primitives placed;
  placed.count = static_cast<layout::uint>(count);
  placed.pitch = static_cast<layout::uint>(padded(count));
  placed.groups = placed.pitch / layout::lanes;
  placed.indices = indices.take(3 * padded(count));
  return placed;
}

// Padding repeats vertex 0: a triangle without area, a line without length.
template <class Primitive>
void write_primitives(const std::vector<Primitive>& primitives, const StoredMesh::Primitives& placed,
                      layout::uint* out) {
  for (int corner = 0; corner < 3; ++corner) {
    layout::uint* plane = out + placed.indices + corner * placed.pitch;
    const int component = std::min(corner, Primitive::length() - 1);
    for (std::size_t i = 0; i < primitives.size(); ++i) plane[i] = primitives[i][component];
    std::fill(plane + primitives.size(), plane + placed.pitch, 0u);
  }
}

glm::vec3 middle_of(const Mesh& mesh) {
  if (mesh.positions.empty()) return glm::vec3(0.0f);
  glm::vec3 low = mesh.positions.front(), high = low;
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return 0.5f * low + 0.5f * high;
}

StoredMesh place(const Mesh& mesh, bool with_uvs, Allocation& data) {
  StoredMesh placed;
  placed.middle = middle_of(mesh);
  const std::size_t pitch = padded(mesh.positions.size());
  placed.pitch = static_cast<layout::uint>(pitch);
  placed.vertex_groups = placed.pitch / layout::lanes;
  placed.positions = data.take(3 * pitch);
  if (!mesh.normals.empty()) placed.normals = data.take(3 * pitch);
  if (!mesh.colors.empty()) placed.colors = data.take(4 * pitch);
  if (with_uvs && !mesh.uvs.empty()) placed.uvs = data.take(2 * pitch);
  for (const MorphTarget& target : mesh.targets) {
    StoredMesh::Target& stored = placed.targets.emplace_back();
    if (!target.positions.empty()) stored.positions = data.take(3 * pitch);
    if (!target.normals.empty() && !mesh.normals.empty()) stored.normals = data.take(3 * pitch);
    if (!target.colors.empty() && !mesh.colors.empty()) stored.colors = data.take(4 * pitch);
  }
  return placed;
}

void write(const Mesh& mesh, const StoredMesh& placed, float* data) {
  write_planes(mesh.positions, placed.pitch, data + placed.positions);
  if (placed.normals != layout::no_id) write_planes(mesh.normals, placed.pitch, data + placed.normals);
  if (placed.colors != layout::no_id) write_planes(mesh.colors, placed.pitch, data + placed.colors);
  if (placed.uvs != layout::no_id) write_planes(mesh.uvs, placed.pitch, data + placed.uvs);
  for (std::size_t i = 0; i < mesh.targets.size(); ++i) {
    const StoredMesh::Target& target = placed.targets[i];
    if (target.positions != layout::no_id)
      write_planes(mesh.targets[i].positions, placed.pitch, data + target.positions);
    if (target.normals != layout::no_id) write_planes(mesh.targets[i].normals, placed.pitch, data + target.normals);
    if (target.colors != layout::no_id) write_planes(mesh.targets[i].colors, placed.pitch, data + target.colors);
  }
}

}  // namespace

MeshStore::MeshStore(std::shared_ptr<Session> session)
    : session_(std::move(session)), data_(context_of(*session_)), indices_(context_of(*session_)) {}

bool MeshStore::require(const FramePlan& plan) {
  if (plan.planner != planner_) {
    stored_.clear();
    order_.clear();
    wants_edges_.clear();
    displaced_.clear();
    planner_ = plan.planner;
  }
  bool changed = wants_uvs_ != plan.has(Channel::uv);
  wants_uvs_ = plan.has(Channel::uv);
  changed |= add_displaced(plan.draws, Frame::this_one);
  changed |= add_displaced(plan.next_draws, Frame::next);
  const Mesh* last = nullptr;
  bool last_lines = false;
  for (const Draw& draw : plan.draws) {
    const bool lines = draw.shading == Shading::wireframe;
    if (draw.mesh == last && lines == last_lines) continue;  // many objects of one mesh follow each other
    last = draw.mesh;
    last_lines = lines;
    const auto [entry, added] = wants_edges_.emplace(draw.mesh, lines);
    if (added) order_.push_back(draw.mesh);
    changed |= added || (lines && !entry->second);
    entry->second |= lines;
  }
  if (changed) {
    planner_ = 0;  // no planner's: an upload that fails leaves nothing to draw from
    upload();
    planner_ = plan.planner;
  }
  upload_displaced(plan.draws, Frame::this_one);
  upload_displaced(plan.next_draws, Frame::next);
  return changed;
}

bool MeshStore::add_displaced(const std::vector<Draw>& draws, Frame frame) {
  bool added = false;
  for (const Draw& draw : draws)
    if (draw.displaced) added |= displaced_.emplace(std::pair{draw.object, frame}, Displaced{draw.mesh}).second;
  return added;
}

void MeshStore::upload_displaced(const std::vector<Draw>& draws, Frame frame) {
  for (const Draw& draw : draws) {
    if (!draw.displaced) continue;
    Displaced& there = displaced_.at({draw.object, frame});
    if (there.uploaded && there.hash == draw.displaced->hash) continue;
    const std::size_t pitch = stored_.at(draw.mesh).pitch;
    planes_.resize(3 * pitch);
    write_planes(draw.displaced->positions, pitch, planes_.data());
    there.uploaded = false;
    checked("uploading displaced positions", [&] {
      queue_of(*session_).enqueueWriteBuffer(data_.buffer(), CL_TRUE, std::size_t{there.positions} * sizeof(float),
                                             planes_.size() * sizeof(float), planes_.data());
    });
    there.uploaded = true;
    there.hash = draw.displaced->hash;
  }
}

void MeshStore::upload() {
  const std::size_t limit = session_->info().max_allocation;
  Allocation data, indices;
  std::unordered_map<const Mesh*, std::vector<glm::uvec2>> edges;
  for (const Mesh* mesh : order_) {
    StoredMesh placed = place(*mesh, wants_uvs_, data);
    placed.triangles = place_primitives(mesh->triangles.size(), indices);
    if (wants_edges_.at(mesh)) {
      edges[mesh] = wireframe_edges(*mesh);
      placed.edges = place_primitives(edges[mesh].size(), indices);
    }
    stored_[mesh] = std::move(placed);
  }
  for (auto& [of_object, there] : displaced_) {
    there.positions = data.take(3 * std::size_t{stored_.at(there.mesh).pitch});
    there.uploaded = false;
  }
  data.check("vertices", limit);
  indices.check("triangles", limit);
  data_.ensure(data.size());
  indices_.ensure(indices.size());
  const auto mapped_data = data_.map(queue_of(*session_), std::max<std::size_t>(data.size(), 1));
  const auto mapped_indices = indices_.map(queue_of(*session_), std::max<std::size_t>(indices.size(), 1));
  for (const Mesh* mesh : order_) {
    const StoredMesh& placed = stored_.at(mesh);
    write(*mesh, placed, mapped_data.data());
    write_primitives(mesh->triangles, placed.triangles, mapped_indices.data());
    if (const auto found = edges.find(mesh); found != edges.end())
      write_primitives(found->second, placed.edges, mapped_indices.data());
  }
}

}  // namespace morphcl
